#pragma once
#include "math/Types.h"
#include "representations/motion/MotionOutput.h"

namespace plumbline {

/// The motion that an OptimizationTrial is about.
REPRESENTATION_OF(SearchedMotionOutput, MotionOutput)
class SearchedMotionOutput : public SearchedMotionOutputBase {
public:
  static constexpr const char* name = "searched";

  SearchedMotionOutput() : SearchedMotionOutputBase(name, true, "trying a motion") {}
  Vec2 ball = Vec2::Zero();  ///< where it wants the ball, robot's ground frame [m]
};

}  // namespace plumbline
