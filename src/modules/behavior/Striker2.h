#pragma once
#include "framework/Module.h"
#include "modules/behavior/striker/KickChoice.h"
#include "representations/behavior/StrikerOutput.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillKickParameters.h"

namespace plumbline {

MODULE(Striker2)
  REQUIRES(GameState)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(FieldDimensions)
  REQUIRES(SkillKickParameters)
  REQUIRES_IF_PROVIDED(OtherRobots)
  PROVIDES(StrikerOutput)
  PARAMETER(bool, kickAllowed, true, "", Range(), "false: the robot only dribbles")
  PARAMETER(double, ballMaxAge, 3, "s", Range(0.1, 60), "a ball that was not seen for longer is searched")
  PARAMETER(double, restartDistance, 2.2, "m", Range(0.5, 10),
            "distance kept from the ball at restarts of the opponent")
  PARAMETER(double, goalMargin, 0.15, "m", Range(0, 1), "the aim lies at least this far inside the posts")
  PARAMETER(double, dribbleDistance, 1.5, "m", Range(0, 30),
            "closer to the goal than this the ball is dribbled in")
  PARAMETER(double, minOpening, 0.15, "rad", Range(0, 1),
            "half the angle between the posts; at a narrower goal in reach the ball is brought nearer first")
  PARAMETER(double, lineDistance, 1, "m", Range(0, 10),
            "then a kick may be used that leaves the ball so far from the goal, else it is dribbled")
  PARAMETER_GROUP(KickChoiceParameters, choice, "where to kick in a team's game")
  PARAMETER(double, duelDistance, 0.8, "m", Range(0, 5),
            "with an opponent this near to the ball the robot acts at once, in the direction it faces")
  PARAMETER(double, duelReach, 0.45, "m", Range(0.1, 3), "a ball this near, and ahead, is kicked in a duel")
  PARAMETER(double, duelWidest, 1.1, "rad", Range(0, 3.2), "a duel's kick goes no farther off the goal")
END_MODULE

/// The player at the ball: kicks at the goal in reach, else brings the ball there; searches a lost ball and
/// keeps its distance at the opponent's restarts.
class Striker2 : public Striker2Base {
public:
  void update(StrikerOutput* theStrikerOutput) override;

private:
  /// The line from the ball that splits the angle between the posts.
  struct Shot {
    Vec2 target = Vec2::Zero();  ///< a point on it as far as the goal [m, field]
    double halfOpening = 0;      ///< half the angle between the posts [rad]
    double distance = 0;         ///< of ball and goal [m]
  };
  Shot shot() const;
  Vec2 wayOn(const Shot& best, bool inReach);
  bool inDuel() const;
  /// The farthest kick that leaves a ball so far from the goal on the field [m]; 0: there is none.
  double kickBeforeTheLine(double toGoal) const;

  double lastAngle_ = 100;  ///< direction of the kick that was chosen last; 100: none [rad]
};

}  // namespace plumbline
