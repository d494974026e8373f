#pragma once
#include "framework/Representation.h"

namespace plumbline {

/// Head angles wanted [rad].
REPRESENTATION(HeadMotionRequest)
class HeadMotionRequest : public HeadMotionRequestBase {
public:
  double yaw = 0;
  double pitch = 0;
  void stream(InStream* in, OutStream* out) override {
    STREAM(yaw);
    STREAM(pitch);
  }
};

}  // namespace plumbline
