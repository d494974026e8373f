#pragma once
#include "framework/Representation.h"

namespace plumbline {

/// Time of the sensor readings of this cycle.
REPRESENTATION(FrameInfo)
class FrameInfo : public FrameInfoBase {
public:
  double time = 0;  ///< clock of the platform [s]
  double cycleSeconds =
      0.02;                ///< time since the last cycle's readings [s]; the nominal cycle in the first one
  unsigned cycle = 0;      ///< counts from 1
  bool restarted = false;  ///< the platform was restarted since the last cycle: forget what was tracked
  void stream(InStream* in, OutStream* out) override {
    STREAM(time);
    STREAM(cycleSeconds);
    STREAM(cycle);
    STREAM(restarted);
  }
};

}  // namespace plumbline
