#pragma once
#include <string>

#include "framework/Module.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/MotionOutput.h"
#include "representations/motion/MotionSelection.h"
#include "representations/skills/SkillOutput.h"

namespace plumbline {

/// Whether StatusReport prints; main gives it to the module's objects.
struct StatusOptions {
  bool wanted = false;
};

MODULE(StatusReport)
  REQUIRES(FrameInfo)
  REQUIRES(GameState)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(FallState)
  REQUIRES(SkillRequest)
  REQUIRES_ALL(SkillOutput)
  REQUIRES_ALL(MotionOutput)
  REQUIRES(MotionSelection)
END_MODULE

/// Where StatusOptions want it (--status), one line per second of the platform's clock on standard output:
/// what the agent believes and does; none before the first message. bin/game shows the last part of it.
class StatusReport : public StatusReportBase {
public:
  void init() override;
  void execute() override;

private:
  /// The motion that drives the joints; null: it is none of the agent's.
  const MotionOutput* motion() const;

  bool wanted_ = false;
  std::string played_;  ///< the motion that MotionPlayer plays; empty: none
  double next_ = -1;
};

/// The words of the status line, e.g. "dribbling", "getting up from the back": what a motion that ends by
/// itself does, otherwise what the requested skill does (null: nothing), otherwise what the motion does.
std::string statusWords(const SkillOutput* skill, const MotionOutput* motion, Posture posture,
                        bool searching);

}  // namespace plumbline
