#pragma once
#include <array>
#include <string>

#include "framework/Representation.h"
#include "representations/motion/MotionRequest.h"

namespace plumbline {

constexpr int numMotions = 5;

/// Which motion drives the joints; ratios sum to 1 while one motion fades into the next.
REPRESENTATION(MotionSelection)
class MotionSelection : public MotionSelectionBase {
public:
  Motion motion = Motion::stand;
  std::array<double, numMotions> ratios{1, 0, 0, 0, 0};  ///< by Motion
  std::string specialAction;
  bool started = false;  ///< the motion was switched to in this cycle
  void stream(InStream* in, OutStream* out) override {
    STREAM(motion);
    STREAM(ratios);
    STREAM(specialAction);
    STREAM(started);
  }
};

}  // namespace plumbline
