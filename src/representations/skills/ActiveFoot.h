#pragma once
#include "framework/Representation.h"
#include "robot/JointId.h"

namespace plumbline {

/// The foot that the ball is to be played with.
REPRESENTATION(ActiveFoot)
class ActiveFoot : public ActiveFootBase {
public:
  Side foot = Side::right;
  void stream(InStream* in, OutStream* out) override { STREAM(foot); }
};

}  // namespace plumbline
