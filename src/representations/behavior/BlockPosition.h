#pragma once
#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// Where a supporter takes an opponent out of play.
REPRESENTATION(BlockPosition)
class BlockPosition : public BlockPositionBase {
public:
  bool valid = false;
  Vec2 position = Vec2::Zero();  ///< team's frame [m]
  int opponent = 0;              ///< number of who is blocked; 0: not known
  void stream(InStream* in, OutStream* out) override {
    STREAM(valid);
    STREAM(position);
    STREAM(opponent);
  }
};

}  // namespace plumbline
