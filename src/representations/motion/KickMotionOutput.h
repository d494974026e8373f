#pragma once
#include "representations/motion/MotionOutput.h"

namespace plumbline {

/// The quick kick.
REPRESENTATION_OF(KickMotionOutput, MotionOutput)
class KickMotionOutput : public KickMotionOutputBase {
public:
  KickMotionOutput() : KickMotionOutputBase(Motion::kick, true, "kicking") {}
};

}  // namespace plumbline
