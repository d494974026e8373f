#pragma once
#include "representations/motion/MotionOutput.h"

namespace plumbline {

/// All joints slack.
REPRESENTATION_OF(DeadMotionOutput, MotionOutput)
class DeadMotionOutput : public DeadMotionOutputBase {
public:
  DeadMotionOutput() : DeadMotionOutputBase(Motion::dead, false, "slack") {}
};

}  // namespace plumbline
