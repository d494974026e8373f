#pragma once
#include <string>
#include <vector>

#include "framework/Representation.h"
#include "math/Types.h"
#include "robot/KickEffect.h"

namespace plumbline {

/// A kick that there is, with the right foot; mirrored for the left.
struct Kick : public Streamable, public KickEffect {
  std::string motion;                     ///< name of the keyframe file without its ending
  Vec2 ballPosition = Vec2(0.16, -0.05);  ///< relative to the robot's ground frame [m]
  void stream(InStream* in, OutStream* out) override {
    STREAM(motion);
    STREAM(ballPosition);
    STREAM(distance);
    STREAM(direction);
    STREAM(contact);
    STREAM(scatter);
    STREAM(spread);
    STREAM(rise);
  }
};

/// The robot's kicks.
REPRESENTATION(SkillKickParameters)
class SkillKickParameters : public SkillKickParametersBase {
public:
  std::vector<Kick> kicks = {Kick()};  ///< at least one, the shortest first

  /// The shortest kick that carries so far [m], else the longest.
  const Kick& kickFor(double metres) const {
    for (const Kick& kick : kicks)
      if (kick.distance >= metres) return kick;
    return kicks.back();
  }
  /// How far the longest kick carries [m].
  double reach() const { return kicks.back().distance; }
  void stream(InStream* in, OutStream* out) override { STREAM(kicks); }
};

}  // namespace plumbline
