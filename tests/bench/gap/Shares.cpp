#include "Shares.h"

#include <cmath>

namespace plumbline::bench {

double boundOf(const Mechanism& robot, const gap::Cause& cause, bool above) {
  const gap::Effect& e = *cause.effect;
  return (above ? e.upper : e.lower) * (e.nominal != 0 ? 1 : e.scaleAt(robot, cause.place));
}

gap::Cause atShare(const Mechanism& robot, gap::Cause cause, double share) {
  const double nominal = cause.effect->nominal, bound = boundOf(robot, cause, share > 0);
  const double part = std::abs(share);
  cause.value = nominal > 0 && bound > 0 ? nominal * std::pow(bound / nominal, part)
                                         : nominal + part * (bound - nominal);
  return cause;
}

}  // namespace plumbline::bench
