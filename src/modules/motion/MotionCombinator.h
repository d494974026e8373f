#pragma once
#include "framework/Module.h"
#include "representations/motion/JointRequest.h"
#include "representations/motion/MotionOutputs.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline {

MODULE(MotionCombinator)
REQUIRES(MotionSelection)
REQUIRES(StandOutput)
REQUIRES(WalkingEngineOutput)
REQUIRES(SpecialActionsOutput)
REQUIRES(KickMotionOutput)
REQUIRES_IF_PROVIDED(DeadMotionOutput)
REQUIRES(HeadMotionRequest)
PROVIDES(JointRequest)
END_MODULE

/// Mixes the motions' joint targets by the selection's ratios. A joint that a motion leaves alone is the
/// others' matter; the head follows the head request unless the selected motion moves it itself.
class MotionCombinator : public MotionCombinatorBase {
public:
  void update(JointRequest* theJointRequest) override;
};

}  // namespace plumbline
