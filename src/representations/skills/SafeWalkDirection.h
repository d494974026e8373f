#pragma once
#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// Which way to walk now so as to reach the place that the skill wants without running into anybody.
REPRESENTATION(SafeWalkDirection)
class SafeWalkDirection : public SafeWalkDirectionBase {
public:
  bool detour = false;                ///< the straight way is not free: walk to wayPoint first
  Vec2 wayPoint = Vec2::Zero();       ///< the next corner of the way, relative to the robot [m]
  bool wait = false;                  ///< a mate that goes before is about to cross: stand still
  Vec2 wayPointField = Vec2::Zero();  ///< the same on the field, to look at [m]
  void stream(InStream* in, OutStream* out) override {
    STREAM(detour);
    STREAM(wayPoint);
    STREAM(wait);
    STREAM(wayPointField);
  }
};

}  // namespace plumbline
