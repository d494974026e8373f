#pragma once
#include "framework/Representation.h"
#include "robot/JointStream.h"

namespace plumbline {

/// Commands to position servos: angles [rad], which compensate load and lag, and stiffness (0..1). Joints
/// that the robot lacks stay 0.
REPRESENTATION(ServoRequest)
class ServoRequest : public ServoRequestBase {
public:
  JointArray angles{};
  JointArray stiffness{};
  void stream(InStream* in, OutStream* out) override {
    STREAM(angles);
    STREAM(stiffness);
  }
};

}  // namespace plumbline
