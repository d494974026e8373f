#pragma once
#include "framework/Module.h"
#include "representations/behavior/BehaviorOutputs.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/infrastructure/PlayerInfo.h"

namespace plumbline {

MODULE(BeforeKickOff)
REQUIRES(GameState)
REQUIRES(PlayerInfo)
REQUIRES(FrameInfo)
PROVIDES(BeforeKickOffOutput)
END_MODULE

/// Puts the robot to its place by SimSpark's beam before a kick-off and after a goal, and waits there.
class BeforeKickOff : public BeforeKickOffBase {
public:
  void init() override;
  void update(BeforeKickOffOutput* theBeforeKickOffOutput) override;

private:
  std::vector<double> x_, y_, heading_;  ///< by uniform number [m, m, rad]
  double beamSeconds_ = 0;               ///< how long the beam is repeated after a change [s]
  bool waiting_ = false;
  double since_ = 0;
};

}  // namespace plumbline
