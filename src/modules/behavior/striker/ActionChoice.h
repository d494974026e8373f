#pragma once
#include <string>
#include <vector>

#include "math/Pose2.h"
#include "modules/behavior/formation/TimeToBall.h"
#include "parameters/Parameter.h"
#include "representations/modeling/OtherRobots.h"
#include "tactics/FieldValue.h"

namespace plumbline {

struct ActionChoiceParameters {
  PARAMETERS(ActionChoiceParameters)
  PARAMETER(int, directions, 17, "", Range(3, 101), "directions that are compared, of each action")
  PARAMETER(double, widest, 1.8, "rad", Range(0.1, 3.1), "the outermost ones, off the direction of the goal")
  PARAMETER(double, kickSeconds, 3, "s", Range(0, 20),
            "to stand exactly behind the ball and kick it, once the robot is there")
  PARAMETER(double, kickScatter, 0.12, "rad", Range(0.01, 1), "standard deviation of a kick's direction")
  PARAMETER(double, dribbleWay, 1.5, "m", Range(0.1, 10), "how far ahead a dribble is judged")
  PARAMETER(double, dribbleSpeed, 0.5, "m/s", Range(0.05, 3), "of the ball while it is dribbled")
  PARAMETER(double, timeSpread, 1, "s", Range(0.05, 10),
            "how sure it is who is first: 73 % for one who is sooner by this")
  PARAMETER(double, blockWidth, 0.4, "m", Range(0, 3),
            "a standing robot this near to the ball's way stops it")
  PARAMETER(double, stays, 0.02, "", Range(0, 1), "value that another action must have more to be taken")
};

/// What the striker knows; team's frame [m, rad].
struct StrikerSituation {
  Pose2 robot;
  Vec2 ball = Vec2::Zero();
  std::vector<double> kicks;  ///< how far each kick carries [m]
  double halfLength = 15, halfWidth = 10, goalHalfWidth = 1.05;
  std::vector<OtherRobot> others;
  Vec2 goal() const { return {halfLength, 0}; }
};

/// What a striker can do with the ball, and what that is worth (FieldValue).
struct StrikerAction {
  enum class Kind { none, kick, dribble };
  Kind kind = Kind::none;
  double direction = 0;  ///< of the ball's way [rad]
  double reach = 0;      ///< how far the kick carries, or a dribble is judged [m]
  double value = -1;
  Vec2 end = Vec2::Zero();  ///< where the ball is expected then [m]
};

/// What an action in a direction is worth: the value of where the ball ends (in the goal, off the field, at a
/// robot in its way, or where it rests) with whoever is first there, if the robot acts before the nearest
/// opponent is at the ball; else the value of losing it here.
StrikerAction judgeAction(StrikerAction::Kind kind, double direction, double reach,
                          const StrikerSituation& situation, const FieldValue& value,
                          const TimeToBallParameters& time, const ActionChoiceParameters& parameters);

/// The action of most value over all kicks, dribbling and directions. last: the one chosen before, kept while
/// no other is worth more by `stays`; of kind none: there was none.
StrikerAction chooseAction(const StrikerSituation& situation, const StrikerAction& last,
                           const FieldValue& value, const TimeToBallParameters& time,
                           const ActionChoiceParameters& parameters);

}  // namespace plumbline
