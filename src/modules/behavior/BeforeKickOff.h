#pragma once
#include "field/TeamSize.h"
#include "framework/Module.h"
#include "representations/behavior/BeforeKickOffOutput.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/infrastructure/PlayerInfo.h"

namespace plumbline {

MODULE(BeforeKickOff)
  REQUIRES(GameState)
  REQUIRES(PlayerInfo)
  REQUIRES(FrameInfo)
  REQUIRES_IF_PROVIDED(PlayerRole)
  PROVIDES(BeforeKickOffOutput)
  PARAMETER(
      std::vector<double>, x, (std::vector<double>{-0.5, -3, -3, -6, -6, -9, -9, -11, -11, -13, -14}), "m",
      Range(-100, 0),
      "places before a kick-off by uniform number, in the own half of the frame of the team, of a player "
      "that knows of no mates")
  PARAMETER(std::vector<double>, y, (std::vector<double>{0, 2, -2, 4, -4, 2, -2, 4, -4, 0, 0}), "m",
            Range(-100, 100), "see x")
  PARAMETER(std::vector<double>, heading, (std::vector<double>(teamSize, 0.0)), "rad", Range(-6.3, 6.3),
            "see x")
  PARAMETER(std::vector<double>, teamX,
            (std::vector<double>{-14.4, -0.2, -7.5, -0.6, -3.8, -5, -5, -1.2, -1.2, -9, -9}), "m",
            Range(-100, 0), "the same in a team; the second one kicks off")
  PARAMETER(std::vector<double>, teamY, (std::vector<double>{0, 0.4, 0.9, 2.6, -4, 2, -2, 7, -7, 2.5, -2.5}),
            "m", Range(-100, 100), "see teamX")
  PARAMETER(double, ringDistance, 2.4, "m", Range(0, 10),
            "kept from the middle before a kick-off of the opponents")
  PARAMETER(double, beamSeconds, 0.5, "s", Range(0.02, 10),
            "time for which the beam is repeated after a change of the play mode")
END_MODULE

/// Puts the robot to its place by SimSpark's beam before a kick-off and after a goal, and waits there.
class BeforeKickOff : public BeforeKickOffBase {
public:
  void parametersChanged() override;
  void update(BeforeKickOffOutput* theBeforeKickOffOutput) override;

private:
  Pose2 place() const;
  bool ownKickOff() const;

  bool waiting_ = false;
  double since_ = 0;
  Vec2 beamed_ = Vec2::Zero();  ///< the last place
};

}  // namespace plumbline
