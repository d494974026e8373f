#pragma once
#include <optional>

#include "framework/Module.h"
#include "modules/behavior/striker/ActionChoice.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/behavior/StrikerDecision.h"
#include "representations/behavior/StrikerOutput.h"
#include "representations/behavior/TeamPlaces.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OppInfo.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillKickParameters.h"
#include "tactics/BallSearch.h"

namespace plumbline {

MODULE(Striker2)
  REQUIRES(FrameInfo)
  REQUIRES(GameState)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(FieldDimensions)
  REQUIRES(SkillKickParameters)
  REQUIRES_IF_PROVIDED(OtherRobots)
  REQUIRES_IF_PROVIDED(OppInfo)
  REQUIRES_IF_PROVIDED(PlayerRole)
  REQUIRES_IF_PROVIDED(TeamPlaces)
  PROVIDES(StrikerOutput)
  PROVIDES(StrikerDecision)
  PARAMETER(bool, kickAllowed, true, "", Range(), "false: the robot only dribbles")
  PARAMETER(double, ballMaxAge, 3, "s", Range(0.1, 60), "a ball that was not seen for longer is searched")
  PARAMETER(double, restartDistance, 2.2, "m", Range(0.5, 10),
            "distance kept from the ball at restarts of the opponent")
  PARAMETER(double, leastTolerance, 0.12, "rad", Range(0.01, 1),
            "a kick never waits for a better direction than within this")
  PARAMETER(double, mostTolerance, 0.35, "rad", Range(0.01, 3.2),
            "nor is it this far off, if nothing depends on it")
  PARAMETER(double, passSeconds, 4, "s", Range(0, 60), "that own pass mode keeps opponents off the ball")
  PARAMETER_GROUP(ActionChoiceParameters, choice, "what to do with the ball if there are other players")
  PARAMETER_GROUP(TimeToBallParameters, time, "how fast players are at the ball")
END_MODULE

/// The player at the ball chooses the action of largest value (ActionChoice): with other players by
/// config/field_value.yaml, alone by the time to the goal. It searches for a lost ball and keeps its distance
/// at the opponent's restarts.
class Striker2 : public Striker2Base {
public:
  void init() override;
  void update(StrikerOutput* theStrikerOutput) override;
  void update(StrikerDecision* theStrikerDecision) override;

private:
  StrikerSituation situation() const;
  void play(BehaviorOutput& output);
  void draw(const StrikerSituation& situation) const;
  StrikerOption optionOf(const StrikerAction& action) const;

  std::optional<FieldValue> value_;
  BallSearch search_;
  double passSince_ = 0;  ///< begin of own pass mode, game clock [s]
  StrikerAction action_;  ///< the one chosen last
  bool plays_ = false;    ///< it chose in this cycle
  Vec2 playedBall_ = Vec2::Zero();
  std::vector<StrikerAction> compared_;  ///< the best of each way to play
};

}  // namespace plumbline
