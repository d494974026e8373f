#pragma once
#include <vector>

#include "framework/Module.h"
#include "modules/behavior/formation/FormationTable.h"
#include "modules/behavior/formation/TeamPlan.h"
#include "modules/behavior/setpiece/SetPieces.h"
#include "representations/behavior/BlockPosition.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/behavior/TeamPlaces.h"
#include "representations/communication/TeamReports.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(Formation)
  REQUIRES(FrameInfo)
  REQUIRES(GameState)
  REQUIRES(PlayerInfo)
  REQUIRES(FieldDimensions)
  REQUIRES(RobotPose)
  REQUIRES(FallState)
  REQUIRES(BallPos)
  REQUIRES(OtherRobots)
  REQUIRES(TeamRobotPose)
  REQUIRES_IF_PROVIDED(BlockPosition)
  PROVIDES(PlayerRole)
  PROVIDES(TeamPlaces)
  PARAMETER_GROUP(TeamPlanParameters, plan, "who does what")
  PARAMETER_GROUP(TimeToBallParameters, time, "time to the ball")
  PARAMETER(double, seenSeconds, 3, "s", Range(0.1, 60),
            "a mate that sends no message takes part if it was seen within that time")
  PARAMETER(double, ballClearance, 1.3, "m", Range(0, 10), "supporters keep this far from the ball")
  PARAMETER(double, restartClearance, 2.3, "m", Range(0, 10), "the same at restarts of the opponent")
  PARAMETER(double, blockReach, 4, "m", Range(0, 20),
            "a supporter whose place is nearer to an opponent to be blocked than that blocks it")
  PARAMETER(double, kickReach, 0.5, "m", Range(0.1, 5),
            "a player this near to the ball at the end of an own restart counts as its taker")
  PARAMETER(double, secondTouchWait, 4, "s", Range(0, 60),
            "longest time for which the taker of a restart waits for another one to touch the ball")
END_MODULE

/// Gives each player its role and place. Every player computes all roles from the messages of all players,
/// including its own message as mates have heard it, so all get the same result (planTeam). So all also know
/// who may be in the own penalty area (areaRights); the places of the others are outside it. Places come from
/// config/formation.yaml, in set pieces first from config/set_pieces/.
class Formation : public FormationBase {
public:
  void init() override;
  void update(PlayerRole* thePlayerRole) override;
  void update(TeamPlaces* theTeamPlaces) override;

private:
  std::vector<TeamMember> members(const PlayerRole& before) const;
  /// A player's time to the ball from its message [s]. If the ball has been kicked since then, it is the time
  /// from the player's reported place to where the ball goes now.
  double timeOf(const TeamBelief& said) const;
  Vec2 keptOff(const Vec2& place) const;
  void watchRestart(PlayerRole& role);
  const SetPiece* setPiece();
  std::vector<Vec2> places();
  void block(std::vector<Vec2>& places) const;
  Pose2 facingBall(const Vec2& place) const;

  FormationTable table_;
  std::vector<PlacedPlayer> placed_;  ///< of this cycle
  Vec2 ball_ = Vec2::Zero();          ///< where the ball will rest, field
  SetPieces pieces_;
  const SetPiece* piece_ = nullptr;  ///< the one whose places hold
  SetPieceSide side_;
  double pieceSeen_ = 0;  ///< its mode was the referee's last [s]
  TeamPlayMode modeBefore_ = TeamPlayMode::unknown;
  double nearAt_ = -1;   ///< when the ball was in reach last in an own restart; negative: never [s]
  double takenAt_ = -1;  ///< when this player took a restart; negative: it did not [s]
};

}  // namespace plumbline
