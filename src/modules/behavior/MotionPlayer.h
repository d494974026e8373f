#pragma once
#include "framework/Module.h"
#include "modules/motion/MotionToPlay.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/FallState.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"
#include "representations/motion/SpecialActionsOutput.h"

namespace plumbline {

MODULE(MotionPlayer)
  REQUIRES(FrameInfo)
  REQUIRES(FallState)
  USES(MotionSelection)
  USES(SpecialActionsOutput)
  PROVIDES(MotionRequest)
END_MODULE

/// Stands for a moment, plays one keyframe motion, stands again: to see a motion without a behaviour. Takes
/// the place of the skills in modules.cfg. Throws ConfigurationError at the start if there is no such motion.
class MotionPlayer : public MotionPlayerBase {
public:
  void init() override;
  void update(MotionRequest* theMotionRequest) override;

private:
  bool justFinished() const;

  const MotionToPlay* wanted_ = nullptr;
  bool playing_ = false, done_ = false;
  double stood_ = 0;  ///< on its feet since the start or the last end of the motion [s]
};

}  // namespace plumbline
