#include "modules/behavior/striker/TimeToGoal.h"

#include <algorithm>
#include <cmath>

#include "math/NormalDistribution.h"
#include "modules/behavior/striker/BallCourse.h"

namespace plumbline {
namespace {

constexpr double distanceStep = 0.25;   ///< of the distance [m]
constexpr double largestDistance = 40;  ///< [m]
constexpr double nearestRest = 1;  ///< a ball before the goal that was meant to be in it lies so far off [m]
constexpr double riseSpread = 0.35;  ///< standard deviation of a kick's height, share of it

}  // namespace

double shareUnderBar(const StrikerSituation& situation, double share, double rise) {
  const double most = situation.goalHeight - 2 * situation.ballRadius;
  const double parabola = share < 1 ? 4 * share * (1 - share) : 0;
  const double height = parabola * rise;
  return height > 1e-6 ? shareBelow((most - height) / (riseSpread * height)) : 1;
}

TimeToGoal::TimeToGoal(const StrikerSituation& situation, const TimeToBallParameters& time,
                       const ActionChoiceParameters& parameters) {
  const double inside = situation.goalHalfWidth - situation.ballRadius;
  for (double distance = 0; distance <= largestDistance; distance += distanceStep) {
    double least = parameters.pushSeconds + distance / parameters.dribbleSpeed;
    for (const KickEffect& kick : situation.kicks) {
      const double over = shareBelow((kick.distance - distance) / std::max(kick.spread, 1e-3));
      const double between = 1 - 2 * shareBelow(-std::atan2(inside, distance) / std::max(kick.scatter, 1e-3));
      const double in =
          over * between * shareUnderBar(situation, distance / (flyingShare * kick.distance), kick.rise);
      // What falls short is walked to. What goes out is laid down after a while, and the robot comes back.
      const double rest = std::max(distance - kick.distance, nearestRest), out = over - in;
      const double after = (1 - over) * ((distance - rest) / time.walkSpeed + seconds(rest));
      const double restart = secondsOfRestart + distance / time.walkSpeed;
      // A miss costs the restart and all over again: the mean of a geometric number of tries.
      if (rest < distance && out < 1)
        least = std::min(least, (parameters.kickSeconds + after + out * restart) / (1 - out));
    }
    seconds_.push_back(least);
  }
}

double TimeToGoal::seconds(double distance) const {
  if (seconds_.empty()) return 0;
  const double at = std::clamp(distance / distanceStep, 0.0, static_cast<double>(seconds_.size() - 1));
  const auto i = static_cast<std::size_t>(at);
  if (i + 1 >= seconds_.size()) return seconds_.back();
  return std::lerp(seconds_[i], seconds_[i + 1], at - static_cast<double>(i));
}

}  // namespace plumbline
