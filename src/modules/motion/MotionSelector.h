#pragma once
#include <string>

#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/FallState.h"
#include "representations/motion/MotionOutputs.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline {

MODULE(MotionSelector)
REQUIRES(FrameInfo)
REQUIRES(MotionRequest)
REQUIRES(FallState)
USES(WalkingEngineOutput)
USES(SpecialActionsOutput)
USES(KickMotionOutput)
PROVIDES(MotionSelection)
END_MODULE

/// Which motion drives the joints: the requested one as soon as the one before it can be left safely. A robot
/// that lies stands up first, whatever is requested, and tries again until it is up.
class MotionSelector : public MotionSelectorBase {
public:
  void init() override;
  void update(MotionSelection* theMotionSelection) override;

private:
  bool safeToLeave(Motion motion) const;
  /// The special action that stands up from how the robot lies.
  const std::string& standUpAction() const;
  void start(MotionSelection& selection, Motion motion, const std::string& specialAction);
  void fade(MotionSelection& selection);

  std::array<double, numMotions> fadeSeconds_{};  ///< to fade into each motion; 0: at once [s]
  std::string standUpFront_, standUpBack_, standUpSide_;
  std::array<double, numMotions> fadeFrom_{};  ///< ratios when the fade began
  double fadeTime_ = 0;                        ///< since the fade began [s]
  bool standingUp_ = false;
  double standUpGrace_ = 0;  ///< after a stand-up, until a robot that still lies tries again [s]
  double grace_ = 0;         ///< what is left of it [s]
};

}  // namespace plumbline
