#pragma once
#include <string>

#include "framework/Representation.h"
#include "math/Pose2.h"
#include "representations/behavior/Skill.h"

namespace plumbline {

/// What a behaviour proposes. A new behaviour is a module that provides a representation of this kind, and a
/// line in modules.cfg: the first one there that is active decides.
///
///     REPRESENTATION_OF(GoalieOutput, BehaviorOutput)
///     class GoalieOutput : public GoalieOutputBase {};
class BehaviorOutput : public Representation {
public:
  static constexpr const char* kindName() { return "BehaviorOutput"; }

  bool active = false;
  std::string skill = Skill::none;  ///< name of a SkillOutput
  Pose2 target;                     ///< see SkillRequest
  double tolerance = 0;             ///< see SkillRequest
  bool beam = false;                ///< the robot wants to be put to beamPose
  Pose2 beamPose;                   ///< in the frame of the team

  void clear() {
    active = beam = false;
    skill = Skill::none;
    target = beamPose = Pose2();
    tolerance = 0;
  }
  void stream(InStream* in, OutStream* out) override {
    STREAM(active);
    STREAM(skill);
    STREAM("targetPosition", target.position);
    STREAM("targetHeading", target.heading);
    STREAM(tolerance);
    STREAM(beam);
    STREAM("beamPosition", beamPose.position);
    STREAM("beamHeading", beamPose.heading);
  }

protected:
  ~BehaviorOutput() = default;
};

}  // namespace plumbline
