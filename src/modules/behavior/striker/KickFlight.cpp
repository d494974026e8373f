#include "modules/behavior/striker/KickFlight.h"

#include "math/NormalDistribution.h"
#include "modules/behavior/striker/ActionChoice.h"

namespace plumbline {
namespace {

constexpr double riseSpread = 0.35;  ///< standard deviation of a kick's height, share of it

}  // namespace

double shareUnderBar(const StrikerSituation& situation, double share, double rise) {
  const double most = situation.goalHeight - 2 * situation.ballRadius;
  const double parabola = share < 1 ? 4 * share * (1 - share) : 0;
  const double height = parabola * rise;
  return height > 1e-6 ? shareBelow((most - height) / (riseSpread * height)) : 1;
}

}  // namespace plumbline
