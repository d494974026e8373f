#pragma once
#include <array>

#include "field/TeamSize.h"
#include "framework/Module.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/communication/TeamBelief.h"
#include "representations/communication/TeamReports.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(BeliefShare)
  REQUIRES(FrameInfo)
  REQUIRES(PlayerInfo)
  REQUIRES(RobotPose)
  REQUIRES(FallState)
  REQUIRES(LocalBallPos)
  REQUIRES(LocalOtherRobots)
  REQUIRES(TeamComDataIn)
  USES(SayMessage)
  USES(PlayerRole)
  PROVIDES(TeamRobotPose)
  PROVIDES(TeamBallPos)
  PROVIDES(TeamOtherRobots)
  PROVIDES(TeamComDataOut)
  PARAMETER(double, memorySeconds, 4, "s", Range(0.5, 60), "words that are older count no more")
  PARAMETER(double, opponentSeconds, 2.5, "s", Range(0.1, 60), "the same for opponents in messages of mates")
  PARAMETER(double, poseNoise, 0.12, "m", Range(1e-3, 5),
            "standard deviation of a position in a mate's message")
  PARAMETER(double, ballDrift, 0.25, "m/s", Range(0, 10), "by which a ball is less certain as time passes")
  PARAMETER(double, robotDrift, 0.4, "m/s", Range(0, 10), "the same of a robot")
  PARAMETER(double, rangeNoise, 0.02, "", Range(0, 1),
            "standard deviation of a ball in a mate's message, as a share of its distance from that mate")
  PARAMETER(double, seenSeconds, 0.5, "s", Range(0.02, 10),
            "opponents seen within that time are in the messages")
END_MODULE

/// The messages between the players of the team: collects received ones and composes the own one. A player
/// sends only a ball that it has seen itself, so that errors do not spread.
class BeliefShare : public BeliefShareBase {
public:
  void execute() override;
  void update(TeamRobotPose* theTeamRobotPose) override;
  void update(TeamBallPos* theTeamBallPos) override;
  void update(TeamOtherRobots* theTeamOtherRobots) override;
  void update(TeamComDataOut* theTeamComDataOut) override;

private:
  void remember(const TeamBelief& belief, double time);
  void addOpponents(TeamBelief& belief) const;

  std::array<TeamReport, teamSize + 1> reports_{};    ///< by number; the own one too
  std::array<OtherRobot, teamSize + 1> opponents_{};  ///< by number, from the last message
  int lastShared_ = 0;                                ///< number of the opponent that was sent last
  double saidBefore_ = -1;                            ///< time of the own last words [s]
};

}  // namespace plumbline
