#pragma once
#include "math/Pose2.h"
#include "trials/KickOptions.h"
#include "trials/TaskOutcome.h"

namespace plumbline {

/// Watches the ball of a try of the task kick and judges the try, for whoever plays it: a worker in its own
/// simulator, or an agent.
class KickMeasure {
public:
  /// robot: where it stands when the kick begins; ball: where the ball lies then [m].
  KickMeasure(const KickOptions& options, const Pose2& robot, const Vec2& ball);

  /// The ball's centre, in each cycle from the kick's beginning until the ball rests [m].
  void see(const Vec3& ball);

  struct End {
    Vec2 ball = Vec2::Zero();  ///< where it came to rest [m]
    double milliseconds = 0;   ///< of the motion
    double error = 0;          ///< angles between torso and upright after it, summed over cycles [rad]
    bool up = false;           ///< AfterMotion::upright in the end
  };
  /// Figures: distance (along the wanted direction) [m], direction (left of forward) [deg], off (from the
  /// wanted direction, without its sign) [deg], height [m], time [ms], error, up. top is the ball's largest
  /// height between 3 and 8 m from its start [m]; low is 1 if top is below the goal's bar and the ball came
  /// so far.
  TaskOutcome outcome(const End& end) const;

private:
  motion::KickWish wish_;
  double direction_;  ///< wanted, left of forward [rad]
  Pose2 robot_;
  Vec2 from_;           ///< the ball's start
  double highest_ = 0;  ///< of its centre [m]
  double top_ = 0;      ///< highest of its top where a goal may stand [m]
  bool came_ = false;   ///< so far that a goal may stand there
};

}  // namespace plumbline
