#pragma once
#include "framework/Representation.h"
#include "robot/ExpectedRobot.h"

namespace plumbline {

/// What has been seen of the opponents so far.
REPRESENTATION(OppInfo)
class OppInfo : public OppInfoBase {
public:
  double walkSpeed = expectedWalkSpeed;  ///< mean of those that walk [m/s]
  double timeToBall = 1e3;  ///< of the first one that stands or gets up [s]; large: none is known
  int nearest = 0;          ///< its number; 0: not known
  double kickDistance = 0;  ///< of their farthest kick [m]; 0: none was seen
  void stream(InStream* in, OutStream* out) override {
    STREAM(walkSpeed);
    STREAM(timeToBall);
    STREAM(nearest);
    STREAM(kickDistance);
  }
};

}  // namespace plumbline
