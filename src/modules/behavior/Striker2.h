#pragma once
#include <optional>

#include "framework/Module.h"
#include "modules/behavior/striker/ActionChoice.h"
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
  PARAMETER_GROUP(ActionChoiceParameters, choice, "what is done with the ball where others play")
  PARAMETER_GROUP(TimeToBallParameters, time, "how fast players are at the ball")
END_MODULE

/// The player at the ball. Alone it kicks at the goal in reach, else brings the ball there; among others it
/// does what is worth most (ActionChoice, config/field_value.yaml). It searches a lost ball and keeps its
/// distance at the opponent's restarts.
class Striker2 : public Striker2Base {
public:
  void init() override;
  void update(StrikerOutput* theStrikerOutput) override;

private:
  /// The line from the ball that splits the angle between the posts.
  struct Shot {
    Vec2 target = Vec2::Zero();  ///< a point on it as far as the goal [m, field]
    double halfOpening = 0;      ///< half the angle between the posts [rad]
    double distance = 0;         ///< of ball and goal [m]
  };
  Shot shot() const;
  /// The farthest kick that leaves a ball so far from the goal on the field [m]; 0: there is none.
  double kickBeforeTheLine(double toGoal) const;
  void playAlone(BehaviorOutput& output) const;
  void playAmongOthers(BehaviorOutput& output);
  void draw(const StrikerSituation& situation) const;

  std::optional<FieldValue> value_;
  StrikerAction action_;  ///< the one chosen last
};

}  // namespace plumbline
