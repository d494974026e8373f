#include "modules/motion/KickMotion.h"

#include <gtest/gtest.h>

#include <memory>

#include "simspark/LeagueRobots.h"
#include "support/LogLines.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"

namespace plumbline {
namespace {

/// Two kicks with the right foot and a motion that is none. Angles in degrees, a cycle of 0.1 s.
class KickMotionTest : public testing::Test {
protected:
  KickMotionTest() {
    write("long", 6, "RHipPitch: -40");
    write("short", 2, "{RHipPitch: -20, RHipRoll: -10, ballX: {RHipPitch: 100}}");
    folder.write("motions/wave.yaml", "keyframes:\n  - {time: 0.2, LShoulderPitch: -60}\n");
    robot.model = simsparkRobot(0);
    robot.name = robot.model.name;
    frame.cycleSeconds = 0.1;
    harness.objects().set(edited);
  }
  void write(const std::string& name, int distance, const std::string& joint) const {
    const std::string keyframe =
        joint[0] == '{' ? "{time: 0.2, " + joint.substr(1) : "{time: 0.2, " + joint + "}";
    folder.write("motions/" + name + ".yaml",
                 "ball: [0.2, -0.05]\nballReach: [0.02, 0.02]\nkick: {distance: " + std::to_string(distance) +
                     "}\nkeyframes:\n  - " + keyframe + "\n");
  }
  /// Begins this kick with the ball where it is expected; so many cycles.
  void kick(const std::string& name, int cycles = 2, Side foot = Side::right,
            const Vec2& off = Vec2::Zero()) {
    request.kick = name;
    request.kickFoot = foot;
    request.kickBall = Vec2(0.2, foot == Side::right ? -0.05 : 0.05) + off;
    selection.motion = Motion::kick;
    selection.started = true;
    for (int i = 0; i < cycles; ++i) {
      harness.cycle();
      selection.started = false;
    }
  }
  double degrees(JointId joint) const { return toDegrees(output.targets.angles[joint]); }

  test::ScratchFolder folder;
  std::shared_ptr<EditedMotion> edited = std::make_shared<EditedMotion>();
  test::ModuleHarness<KickMotion> harness{{folder.path()}};
  FrameInfo& frame = harness.input<FrameInfo>();
  RobotDescription& robot = harness.input<RobotDescription>();
  MotionRequest& request = harness.input<MotionRequest>();
  MotionSelection& selection = harness.input<MotionSelection>();
  JointData& joints = harness.input<JointData>();
  const KickMotionOutput& output = harness.output<KickMotionOutput>();
};

TEST_F(KickMotionTest, playsTheAskedKickFromTheMeasuredAnglesToItsEnd) {
  joints.angles[rHipPitch] = fromDegrees(10);
  kick("long", 1);
  EXPECT_NEAR(degrees(rHipPitch), -15, 1e-9);
  EXPECT_FALSE(output.finished);
  EXPECT_FALSE(output.targets.set[lHipPitch]);
  harness.cycle();
  EXPECT_NEAR(degrees(rHipPitch), -40, 1e-9);
  EXPECT_TRUE(output.finished);
}

TEST_F(KickMotionTest, withoutANameItIsTheShortest) {
  kick("");
  EXPECT_NEAR(degrees(rHipPitch), -20, 1e-9);
}

TEST_F(KickMotionTest, theOtherFootPlaysTheMirrorImage) {
  kick("short", 2, Side::left);
  EXPECT_NEAR(degrees(lHipPitch), -20, 1e-9);
  EXPECT_NEAR(degrees(lHipRoll), 10, 1e-9);
  EXPECT_FALSE(output.targets.set[rHipPitch]);
}

TEST_F(KickMotionTest, followsTheBallAsFarAsItReaches) {
  kick("short", 2, Side::right, Vec2(0.01, 0));
  EXPECT_NEAR(degrees(rHipPitch), -19, 1e-9) << "a degree per centimetre";
  kick("short", 2, Side::right, Vec2(0.1, 0));
  EXPECT_NEAR(degrees(rHipPitch), -18, 1e-9);
}

TEST_F(KickMotionTest, anUnknownKickAndAMotionThatIsNoneEndAtOnceAndAreLogged) {
  test::LogLines log;
  kick("curl", 1);
  EXPECT_TRUE(output.finished);
  kick("wave", 1);
  EXPECT_TRUE(output.finished);
  EXPECT_EQ(log.lines, (std::vector<std::string>{"error: there is no kick \"curl\" in motions/",
                                                 "error: there is no kick \"wave\" in motions/"}));
}

TEST_F(KickMotionTest, anEditedFileIsReadAnewUnlessItIsBroken) {
  kick("long");
  write("long", 6, "RHipPitch: -30");
  edited->save();
  kick("long");
  EXPECT_NEAR(degrees(rHipPitch), -30, 1e-9);
  test::LogLines log;
  write("long", 6, "RHipPich: -20");
  edited->save();
  kick("long");
  EXPECT_NEAR(degrees(rHipPitch), -30, 1e-9);
  EXPECT_EQ(log.lines,
            std::vector<std::string>{"error: the kick stays as it was: " + folder / "motions/long.yaml" +
                                     ":5: RHipPich: unknown joint; did you mean \"RHipPitch\"?"});
}

TEST_F(KickMotionTest, aRobotThatIsNotKnownDoesNotKick) {
  robot.name.clear();
  kick("long");
  EXPECT_FALSE(output.targets.set[rHipPitch]);
}

}  // namespace
}  // namespace plumbline
