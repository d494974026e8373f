#pragma once
#include "framework/Representation.h"
#include "representations/motion/MotionRequest.h"

namespace plumbline {

/// What one skill wants of the motions.
struct SkillOutput : public Streamable {
  bool active = false;
  Motion motion = Motion::stand;
  Vec2 walkVelocity = Vec2::Zero();  ///< [m/s]
  double walkTurn = 0;               ///< [rad/s]
  Side kickFoot = Side::right;
  Vec2 kickBall = Vec2::Zero();
  void stream(InStream* in, OutStream* out) override {
    STREAM(active);
    STREAM(motion);
    STREAM(walkVelocity);
    STREAM(walkTurn);
    STREAM(kickFoot);
    STREAM(kickBall);
  }
};

REPRESENTATION(SkillMoveToPosOutput)
class SkillMoveToPosOutput : public SkillMoveToPosOutputBase {
public:
  SkillOutput output;
  void stream(InStream* in, OutStream* out) override { STREAM(output); }
};

REPRESENTATION(SkillGetBallOutput)
class SkillGetBallOutput : public SkillGetBallOutputBase {
public:
  SkillOutput output;
  bool atBall = false;  ///< in reach of a kick, heading as requested
  void stream(InStream* in, OutStream* out) override {
    STREAM(output);
    STREAM(atBall);
  }
};

REPRESENTATION(SkillKickOutput)
class SkillKickOutput : public SkillKickOutputBase {
public:
  SkillOutput output;
  void stream(InStream* in, OutStream* out) override { STREAM(output); }
};

REPRESENTATION(SkillDribbleOutput)
class SkillDribbleOutput : public SkillDribbleOutputBase {
public:
  SkillOutput output;
  void stream(InStream* in, OutStream* out) override { STREAM(output); }
};

}  // namespace plumbline
