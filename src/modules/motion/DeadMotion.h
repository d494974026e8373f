#pragma once
#include "framework/Module.h"
#include "representations/motion/DeadMotionOutput.h"

namespace plumbline {

MODULE(DeadMotion)
  PROVIDES(DeadMotionOutput)
END_MODULE

/// Makes every joint slack. For robots that can: SimSpark's motors cannot, and it is never selected there.
class DeadMotion : public DeadMotionBase {
public:
  void update(DeadMotionOutput* theDeadMotionOutput) override;
};

}  // namespace plumbline
