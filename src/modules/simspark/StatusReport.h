#pragma once
#include "framework/Module.h"
#include "modules/simspark/AgentOptions.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline {

MODULE(StatusReport)
REQUIRES(FrameInfo)
REQUIRES(GameState)
REQUIRES(RobotPose)
REQUIRES(BallPos)
REQUIRES(FallState)
REQUIRES(SkillRequest)
REQUIRES(MotionSelection)
END_MODULE

/// With --status, one line per second of the platform's clock on standard output: what the agent believes and
/// does. bin/game shows the last part of it.
class StatusReport : public StatusReportBase {
public:
  void init() override;
  void execute() override;

private:
  bool on_ = false;
  double next_ = -1;
};

/// The words of the status line, e.g. "dribbling", "getting up from the back".
std::string statusWords(Skill skill, Motion motion, Posture posture, bool searching);

}  // namespace plumbline
