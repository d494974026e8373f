#pragma once
#include "framework/Representation.h"
#include "robot/JointStream.h"

namespace plumbline {

/// Measured joint angles [rad]; joints that the robot lacks stay 0.
REPRESENTATION(JointData)
class JointData : public JointDataBase {
public:
  JointArray angles{};
  void stream(InStream* in, OutStream* out) override { STREAM(angles); }
};

}  // namespace plumbline
