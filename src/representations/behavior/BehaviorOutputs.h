#pragma once
#include "framework/Representation.h"
#include "representations/behavior/SkillRequest.h"

namespace plumbline {

/// What one behaviour proposes; the combinator takes the first active one.
struct BehaviorOutput : public Streamable {
  bool active = false;
  Skill skill = Skill::none;
  Pose2 target;
  bool beam = false;
  Pose2 beamPose;
  void stream(InStream* in, OutStream* out) override {
    STREAM(active);
    STREAM(skill);
    STREAM("targetPosition", target.position);
    STREAM("targetHeading", target.heading);
    STREAM(beam);
    STREAM("beamPosition", beamPose.position);
    STREAM("beamHeading", beamPose.heading);
  }
};

REPRESENTATION(BeforeKickOffOutput)
class BeforeKickOffOutput : public BeforeKickOffOutputBase {
public:
  BehaviorOutput output;
  void stream(InStream* in, OutStream* out) override { STREAM(output); }
};

REPRESENTATION(StrikerOutput)
class StrikerOutput : public StrikerOutputBase {
public:
  BehaviorOutput output;
  void stream(InStream* in, OutStream* out) override { STREAM(output); }
};

}  // namespace plumbline
