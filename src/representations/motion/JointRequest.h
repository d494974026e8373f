#pragma once
#include <array>

#include "framework/Representation.h"
#include "robot/JointStream.h"

namespace plumbline {

/// Target angles [rad] and stiffness (0..1, where the platform has it); a joint with set = false is left
/// alone.
struct JointTargets : public Streamable {
  JointArray angles{};
  JointFlags set{};
  JointArray stiffness = [] {
    JointArray all;
    all.fill(1.0);
    return all;
  }();
  void setTo(JointId joint, double angle) {
    angles[joint] = angle;
    set[joint] = true;
  }
  void stream(InStream* in, OutStream* out) override {
    STREAM(angles);
    STREAM(set);
    STREAM(stiffness);
  }
};

REPRESENTATION(JointRequest)
class JointRequest : public JointRequestBase {
public:
  JointTargets targets;
  void stream(InStream* in, OutStream* out) override { STREAM(targets); }
};

/// Hinge speeds for SimSpark's velocity motors [rad/s].
REPRESENTATION(JointRequestWithSpeeds)
class JointRequestWithSpeeds : public JointRequestWithSpeedsBase {
public:
  JointArray speeds{};
  void stream(InStream* in, OutStream* out) override { STREAM(speeds); }
};

}  // namespace plumbline
