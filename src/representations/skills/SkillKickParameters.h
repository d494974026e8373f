#pragma once
#include <string>

#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// Where the ball has to lie for the quick kick with the right foot, from config/kick.yaml; mirrored for the
/// left.
REPRESENTATION(SkillKickParameters)
class SkillKickParameters : public SkillKickParametersBase {
public:
  Vec2 ballPosition = Vec2(0.16, -0.05);  ///< relative to the robot's ground frame [m]
  Vec2 tolerance = Vec2(0.03, 0.03);      ///< [m]
  double headingTolerance = 0.15;         ///< [rad]
  double distance = 3;                    ///< how far the kick carries [m]
  void stream(InStream* in, OutStream* out) override {
    STREAM(ballPosition);
    STREAM(tolerance);
    STREAM(headingTolerance);
    STREAM(distance);
  }
};

}  // namespace plumbline
