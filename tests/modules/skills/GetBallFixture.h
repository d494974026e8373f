#pragma once
#include <gtest/gtest.h>

#include "modules/skills/SkillGetBall.h"
#include "modules/skills/SkillWish.h"
#include "representations/skills/SkillKickOutput.h"

namespace plumbline::test {

/// A robot at the origin that looks along x, with one kick with the right foot.
struct GetBallTest : testing::Test {
  GetBallTest() {
    harness.input<FrameInfo>().cycleSeconds = 0.02;
    SkillKickParameters& kick = harness.input<SkillKickParameters>();
    kick.kicks = {Kick()};
    kick.kicks[0].motion = "kickRight";
    kick.kicks[0].ballPosition = {0.16, -0.05};
    harness.input<ActiveFoot>();
    harness.input<SkillKickOutput>();  // how a skill wants to stand at the ball, its output says
  }
  /// How exactly it has to stand and how it learns a drift, instead of what the configuration says; after the
  /// inputs were named.
  void setTolerances(double heading = 0.15) {
    BallPositioningParameters& p = harness.module().positioning;
    p.toleranceForward = p.toleranceSideways = 0.03;
    p.toleranceHeading = heading;
    p.leaveTolerances = 1.4;
    p.biasGain = 1.5;
    p.biasDistance = p.maxBias = 0.15;
  }
  /// The ball lies here, and shall go along x.
  const SkillGetBallOutput& ballAt(const Vec2& ball, const char* skill = Skill::kick) {
    wish(harness, skill, Pose2(10, ball.y(), 0));
    harness.input<RobotPose>().pose = Pose2();
    harness.input<BallPos>().relative = ball;
    harness.input<BallPos>().field = ball;
    setTolerances();
    harness.cycle();
    return harness.output<SkillGetBallOutput>();
  }
  ModuleHarness<SkillGetBall> harness;
};

}  // namespace plumbline::test
