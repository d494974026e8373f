#pragma once
#include <vector>

#include "modules/behavior/striker/ActionChoice.h"

namespace plumbline {

/// How long a robot that is alone on the field still needs to score, with a ball straight before the goal.
/// It is the least mean time over all orders of its kicks and dribbling, by dynamic programming over the
/// distance (Bellman 1957). A long kick is a way to walk before the next one, so a short kick and then a long
/// shot may be sooner than the other way round.
class TimeToGoal {
public:
  static constexpr double restartSeconds = 15;  ///< until a ball that went out is laid down and in play [s]

  TimeToGoal(const StrikerSituation& situation, const TimeToBallParameters& time,
             const ActionChoiceParameters& parameters);

  /// distance: of the ball from the middle of the goal [m]. From when the robot is at the ball [s].
  double seconds(double distance) const;

private:
  std::vector<double> seconds_;  ///< by steps of distance
};

}  // namespace plumbline
