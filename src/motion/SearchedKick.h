#pragma once
#include <vector>

#include "motion/MotionParameters.h"
#include "parameters/Parameter.h"

namespace plumbline::motion {

/// A kick whose keyframes and place of the ball are searched: the numbers of MotionParameters, left and right
/// apart, then ballX and ballY [mm].
class SearchedKick {
public:
  /// Begins with this kick, mirrored if it is for the other foot and without a shift with the ball, which
  /// would be judged together with the ball's spread. Throws std::invalid_argument for a motion without a
  /// ball.
  SearchedKick(const KeyframeMotion& kick, const RobotModel& robot, Side foot);

  const std::vector<SearchedNumber>& list() const { return list_; }
  const KeyframeMotion& first() const { return first_; }
  /// The kick with these numbers as its file has it; cycle as for MotionParameters::written.
  KeyframeMotion written(const Eigen::VectorXd& values, double cycle) const;

private:
  KeyframeMotion first_;
  MotionParameters motion_;
  std::vector<SearchedNumber> list_;
};

/// Result of a try of a kick.
struct KickTry {
  Vec2 way = Vec2::Zero();  ///< of the ball, x along the wanted direction, y to its left [m]
  double height = 0;        ///< that the ball rose [m]
  double top = 0;           ///< of the ball where a goal may stand, the highest [m]
  double milliseconds = 0;  ///< of the motion
  double error = 0;         ///< angles between torso and upright after it, summed over cycles [rad]

  /// 0 for a ball that hardly moved [rad].
  double direction() const;
};

/// Goal of a search for a kick.
struct KickWish {
  PARAMETERS(KickWish)
  PARAMETER(double, distance, 0, "m", Range(0, 30),
            "how far the ball is to go in the wanted direction; 0: as far as it goes")
  PARAMETER(double, weight, 0.08, "1/ms", Range(0, 100), "worth of a millisecond of the motion")
  PARAMETER(double, steady, 1, "1/rad", Range(0, 100), "worth of a radian of lean in a cycle of the walk")
  PARAMETER(double, ceiling, 0, "m", Range(0, 5),
            "what the ball's top is to stay below between 3 and 8 m, for shots (a goal's bar is at 0.8 m); "
            "0: no such bound")

  /// Formula 3.2 of Seekircher 2015 with the opposite sign and the ball's path split in two:
  ///   -30 (along - aside) - 120 min(1, height) + steady error + weight milliseconds.
  /// With a distance, 30 |along - distance| replaces -30 along, and height does not count. With a ceiling,
  /// height does not count either, and a top above it costs 60 + 300 (top - ceiling).
  double cost(const KickTry& kick) const;
};

}  // namespace plumbline::motion
