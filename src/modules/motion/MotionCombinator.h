#pragma once
#include "framework/Module.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/JointRequest.h"
#include "representations/motion/MotionOutput.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline {

MODULE(MotionCombinator)
  REQUIRES(MotionSelection)
  REQUIRES_ALL(MotionOutput)
  REQUIRES(HeadMotionRequest)
  PROVIDES(JointRequest)
END_MODULE

/// Mixes the motions' joint targets by the selection's ratios. A joint that a motion leaves alone is the
/// others' matter; the head follows the head request unless the selected motion moves it itself.
class MotionCombinator : public MotionCombinatorBase {
public:
  void update(JointRequest* theJointRequest) override;

private:
  std::vector<double> ratios_;  ///< of this cycle, by motion
};

}  // namespace plumbline
