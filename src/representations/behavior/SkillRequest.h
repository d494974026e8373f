#pragma once
#include <string>

#include "framework/Representation.h"
#include "math/Pose2.h"
#include "representations/behavior/Skill.h"

namespace plumbline {

/// What a behaviour wants done; positions in the team's field frame [m, rad].
REPRESENTATION(SkillRequest)
class SkillRequest : public SkillRequestBase {
public:
  std::string skill = Skill::none;  ///< name of a SkillOutput
  Pose2 target;  ///< moveToPos: where to be; getBall: heading to have at the ball; kick, dribble: where the
                 ///< ball goes
  double tolerance =
      0;  ///< kick: the ball may go so far off the target's direction; 0: the skill's own [rad]
  bool lookForBall = true;
  void stream(InStream* in, OutStream* out) override {
    STREAM(skill);
    STREAM("targetPosition", target.position);
    STREAM("targetHeading", target.heading);
    STREAM(tolerance);
    STREAM(lookForBall);
  }
};

/// Where the robot wants to be put before a kick-off (team's frame, as SimSpark's beam effector takes it).
REPRESENTATION(BeamRequest)
class BeamRequest : public BeamRequestBase {
public:
  bool active = false;
  Pose2 pose;
  void stream(InStream* in, OutStream* out) override {
    STREAM(active);
    STREAM("position", pose.position);
    STREAM("heading", pose.heading);
  }
};

}  // namespace plumbline
