#pragma once
#include <string>
#include <vector>

#include "field/FieldSize.h"
#include "math/Pose2.h"
#include "modules/behavior/formation/TimeToBall.h"
#include "parameters/Parameter.h"
#include "representations/behavior/TeamPlaces.h"
#include "representations/modeling/OtherRobots.h"
#include "robot/ExpectedRobot.h"
#include "robot/KickEffect.h"
#include "tactics/FieldValue.h"

namespace plumbline {

struct ActionChoiceParameters {
  PARAMETERS(ActionChoiceParameters)
  PARAMETER(int, directions, 105, "", Range(24, 720),
            "directions all round that are compared, of each action")
  PARAMETER(double, widest, 2.0, "rad", Range(0.1, 3.1), "the outermost ones, off the direction of the goal")
  PARAMETER(double, kickSeconds, 1.5, "s", Range(0, 20),
            "time to stand exactly behind the ball and kick it, once the robot is there")
  PARAMETER(double, pushSeconds, 0.3, "s", Range(0, 20),
            "until a dribbled ball moves, once the robot is there")
  PARAMETER(
      double, roundSeconds, 2.5, "s", Range(0, 20),
      "to get round the ball, for a robot on the wrong side of it; less for smaller angles, in proportion")
  PARAMETER(double, dribbleWay, 1.5, "m", Range(0.1, 10), "how far ahead a dribble is judged")
  PARAMETER(double, dribbleSpeed, 0.5, "m/s", Range(0.05, 3), "of the ball while it is dribbled")
  PARAMETER(double, dribbleScatter, 0.1, "rad", Range(0.01, 1),
            "standard deviation of a dribbled ball's direction")
  PARAMETER(
      double, goalWorth, 1.8, "", Range(1, 10),
      "of a goal while others play, where 1 is the value of being sure to score the next one; the more, "
      "the sooner the striker shoots instead of waiting for a safer shot")
  PARAMETER(double, timeSpread, 0.5, "s", Range(0.05, 10),
            "uncertainty of which player is first: 73 % for the one that is sooner by this")
  PARAMETER(double, timePrice, 0.01, "1/s", Range(0, 1), "value that a second costs")
  PARAMETER(double, blockWidth, 0.35, "m", Range(0, 3),
            "a standing robot this near to the ball's way stops it")
  PARAMETER(double, pushThrough, 0.4, "", Range(0, 1),
            "share of its way beyond a robot that a dribble still makes")
  PARAMETER(double, blockSpeed, 0.25, "m/s", Range(0, 3),
            "opponents come so much nearer to the way while the ball rolls")
  PARAMETER(double, goalKickWay, 7, "m", Range(0, 30),
            "a ball over the opponents' line is theirs so far before it, after their goal kick")
  PARAMETER(double, hysteresis, 0.02, "", Range(0, 1),
            "additional value that another action needs to replace the last choice")
  PARAMETER(
      double, hysteresisAtBall, 0.1, "", Range(0, 1),
      "the same for a robot at the ball, which has taken its position; interpolated between 1 m and the ball")
  PARAMETER(double, slack, 0.03, "", Range(0, 1),
            "value that a kick may lose by its direction, so that it is not waited for a better one")
};

/// What the striker knows; team's frame [m, rad].
struct StrikerSituation {
  Pose2 robot;
  Vec2 ball = Vec2::Zero();
  std::vector<KickEffect> kicks;
  double halfLength = FieldSize().length / 2, halfWidth = FieldSize().width / 2;
  double goalHalfWidth = FieldSize().goalWidth / 2, goalHeight = FieldSize().goalHeight;
  double ballRadius = FieldSize().ballRadius;
  std::vector<OtherRobot> others;
  TeamPlaces places;                         ///< where mates look and go
  double freeSeconds = 0;                    ///< time in which opponents must stay away from the ball [s]
  double opponentSpeed = expectedWalkSpeed;  ///< of opponents on their way to the ball [m/s]
  Vec2 goal() const { return {halfLength, 0}; }
};

/// An action of a striker with the ball, and its value (FieldValue).
struct StrikerAction {
  enum class Kind { none, kick, dribble };
  Kind kind = Kind::none;
  double direction = 0;  ///< of the ball's way [rad]
  double reach = 0;      ///< how far the kick carries, or a dribble is judged [m]
  double value = -1;
  double goal = 0;  ///< probability that the ball goes in
  double tolerance =
      0;  ///< a kick may go so far aside, to either side, and is worth as much but `slack` [rad]
  Vec2 end = Vec2::Zero();  ///< where a ball in the middle of the scatter ends [m]
};

/// Returns the action with the largest value over all kicks, dribbling and directions. The value of each is
/// integrated over its scatter. The ball goes into the goal (between the posts and under the bar), off the
/// field, to a robot in its way, or stops and then belongs to the robot that is first there. This holds if
/// the robot acts before the nearest opponent is at the ball; else the ball is lost here. last: the previous
/// choice, kept unless another is worth more by `hysteresis`; kind none: there was none. compared: if not
/// null, it gets the best direction of each kick and of dribbling.
StrikerAction chooseAction(const StrikerSituation& situation, const StrikerAction& last,
                           const FieldValue& value, const TimeToBallParameters& time,
                           const ActionChoiceParameters& parameters,
                           std::vector<StrikerAction>* compared = nullptr);

/// The value of one action in one direction.
StrikerAction judgeAction(StrikerAction::Kind kind, double direction, double reach,
                          const StrikerSituation& situation, const FieldValue& value,
                          const TimeToBallParameters& time, const ActionChoiceParameters& parameters);

}  // namespace plumbline
