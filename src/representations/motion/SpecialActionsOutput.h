#pragma once
#include "representations/motion/MotionOutput.h"

namespace plumbline {

/// Keyframes of motions/; which one, MotionRequest::specialAction says.
REPRESENTATION_OF(SpecialActionsOutput, MotionOutput)
class SpecialActionsOutput : public SpecialActionsOutputBase {
public:
  SpecialActionsOutput() : SpecialActionsOutputBase(Motion::specialAction, true, "getting up") {}
};

}  // namespace plumbline
