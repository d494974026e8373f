#pragma once
#include <string>

#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/FallState.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"
#include "representations/motion/SpecialActionsOutput.h"

namespace plumbline {

/// Which motion the module MotionPlayer plays; main gives it to the module's objects.
struct MotionToPlay {
  std::string name;   ///< of a file in motions/, without its ending
  bool once = false;  ///< then the agent ends; otherwise again and again
};

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
