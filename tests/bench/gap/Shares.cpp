#include "Shares.h"

#include <cmath>

namespace plumbline::bench {

double boundOf(const Mechanism& robot, const gap::Cause& cause, bool above) {
  const gap::Bounds bounds = cause.effect->boundsAt(robot, cause.place);
  return above ? bounds.upper : bounds.lower;
}

gap::Cause atShare(const Mechanism& robot, gap::Cause cause, double share) {
  const double nominal = cause.effect->nominal, bound = boundOf(robot, cause, share > 0);
  const double part = std::abs(share);
  cause.value = nominal > 0 && bound > 0 ? nominal * std::pow(bound / nominal, part)
                                         : nominal + part * (bound - nominal);
  return cause;
}

}  // namespace plumbline::bench
