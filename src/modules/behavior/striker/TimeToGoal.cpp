#include "modules/behavior/striker/TimeToGoal.h"

#include <algorithm>
#include <cmath>

#include "math/NormalDistribution.h"
#include "modules/behavior/striker/KickFlight.h"

namespace plumbline {
namespace {

constexpr double distanceStep = 0.25;  ///< of the table [m]
constexpr double nearestRest = 1;  ///< a ball that was meant to be in the goal and is not lies so far off [m]

}  // namespace

TimeToGoal::TimeToGoal(const StrikerSituation& situation, const TimeToBallParameters& time,
                       const ActionChoiceParameters& parameters) {
  const double inside = situation.goalHalfWidth - situation.ballRadius;
  // From the middle of the goal to the farthest corner, and so far that it can be interpolated there.
  const double farthest = std::hypot(2 * situation.halfLength, situation.halfWidth) + distanceStep;
  for (double distance = 0; distance <= farthest; distance += distanceStep) {
    double least = parameters.pushSeconds + distance / parameters.dribbleSpeed;
    for (const KickEffect& kick : situation.kicks) {
      const double rest = std::max(distance - kick.distance, nearestRest);
      if (rest >= distance) continue;
      const double over = shareBelow((kick.distance - distance) / std::max(kick.spread, 1e-3));
      const double between = 1 - 2 * shareBelow(-std::atan2(inside, distance) / std::max(kick.scatter, 1e-3));
      const double in =
          over * between * shareUnderBar(situation, distance / (flyingShare * kick.distance), kick.rise);
      const double out = over - in;
      if (out >= 1) continue;
      // What falls short is walked to. What goes out is laid down after a while, and the robot comes back.
      const double after = (1 - over) * ((distance - rest) / time.walkSpeed + seconds(rest));
      const double restart = restartSeconds + distance / time.walkSpeed;
      // A miss costs the restart and all over again: the mean of a geometric number of tries.
      least = std::min(least, (parameters.kickSeconds + after + out * restart) / (1 - out));
    }
    seconds_.push_back(least);
  }
}

double TimeToGoal::seconds(double distance) const {
  const double at = std::clamp(distance / distanceStep, 0.0, static_cast<double>(seconds_.size() - 1));
  const auto i = static_cast<std::size_t>(at);
  if (i + 1 >= seconds_.size()) return seconds_.back();
  return std::lerp(seconds_[i], seconds_[i + 1], at - static_cast<double>(i));
}

}  // namespace plumbline
