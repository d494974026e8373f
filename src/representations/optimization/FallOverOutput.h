#pragma once
#include "representations/motion/MotionOutput.h"

namespace plumbline {

/// Falls, for tries of standing up.
REPRESENTATION_OF(FallOverOutput, MotionOutput)
class FallOverOutput : public FallOverOutputBase {
public:
  static constexpr const char* name = "fallOver";

  FallOverOutput() : FallOverOutputBase(name, false, "falling for a try") {}
};

}  // namespace plumbline
