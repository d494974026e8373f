#pragma once
#include "representations/motion/MotionOutput.h"

namespace plumbline {

/// The stand of the walk.
REPRESENTATION_OF(StandOutput, MotionOutput)
class StandOutput : public StandOutputBase {
public:
  StandOutput() : StandOutputBase(Motion::stand, false, "standing") {}
};

}  // namespace plumbline
