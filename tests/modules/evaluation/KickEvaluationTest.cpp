#include "modules/evaluation/KickEvaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "math/Angle.h"
#include "modules/evaluation/OutputProblems.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

constexpr const char* kickColumns = "time,kick,foot,x,y,believedX,believedY,heading,way,direction\n";

class KickEvaluationTest : public testing::Test {
protected:
  KickEvaluationTest() {
    harness->input<PlayerInfo>().number = 5;
    Kick kick;
    kick.motion = "kickLong";
    kick.ballPosition = {0.16, -0.05};
    harness->input<SkillKickParameters>().kicks = {kick};
    truth().valid = true;
    truth().T_field_torso = translation(1, 2, 0.4);
    truth().ball = Vec3(1.18, 1.94, 0.04);
    harness->input<RobotPose>().pose = Pose2(1, 2, fromDegrees(3));
    request().kick = "kickLong";
    request().kickBall = {0.17, -0.055};
  }
  GroundTruth& truth() { return harness->input<GroundTruth>(); }
  MotionRequest& request() { return harness->input<MotionRequest>(); }
  void cycle(double time, bool starts = false) {
    harness->input<FrameInfo>().time = time;
    MotionSelection& selection = harness->input<MotionSelection>();
    selection.motion = starts ? Motion::kick : Motion::walk;
    selection.started = starts;
    harness->cycle();
  }
  std::string written() { return folder.read("deep/left-5.csv"); }
  std::vector<std::string> configured() const {
    folder.write("KickEvaluation.yaml", "folder: " + folder / "deep" + "\n");
    return {folder.path()};
  }
  test::ScratchFolder folder;
  std::optional<test::ModuleHarness<KickEvaluation>> harness{configured()};
};

TEST_F(KickEvaluationTest, writesWhereTheBallLayAndHowFarItWent) {
  cycle(9);
  cycle(10, true);
  truth().ball = Vec3(4.18, 4.94, 0.04);
  cycle(13.9);
  EXPECT_EQ(written(), "") << "the ball still rolls";
  cycle(14.1);
  EXPECT_EQ(written(),
            std::string(kickColumns) + "10.00,kickLong,right,0.0200,-0.0100,0.0100,-0.0050,3.00,4.24,45.0\n");
  cycle(20);
  EXPECT_EQ(std::ranges::count(written(), '\n'), 2) << "one line of each kick";
}

TEST_F(KickEvaluationTest, theLeftFootsKickIsMirrored) {
  truth().ball.y() = 2.06;
  request().kickFoot = Side::left;
  request().kickBall.y() = 0.055;
  cycle(10, true);
  harness.reset();
  EXPECT_EQ(written(),
            std::string(kickColumns) + "10.00,kickLong,left,0.0200,-0.0100,0.0100,-0.0050,3.00,0.00,0.0\n")
      << "what has begun when the agent ends is written";
}

TEST_F(KickEvaluationTest, theNextKickEndsTheOneBefore) {
  cycle(10, true);
  truth().ball.x() = 2.18;
  cycle(11, true);
  harness.reset();
  EXPECT_NE(written().find(",1.00,0.0\n11.00,kickLong,right,1.0200,"), std::string::npos) << written();
}

TEST_F(KickEvaluationTest, withoutTheTruthNothingIsWritten) {
  truth().valid = false;
  cycle(10, true);
  EXPECT_EQ(written(), "");
}

TEST_F(KickEvaluationTest, aFileThatCannotBeWrittenIsSaidOnce) {
  cycle(9);
  folder.write("deep/left-5.csv/in", "the way");
  testing::internal::CaptureStderr();
  for (int i = 0; i < 4; ++i) cycle(10 + i, true);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "the kicks end here: " + folder / "deep/left-5.csv" +
                ": cannot be written: Is a directory; make room, or choose another folder\n");
  EXPECT_TRUE(harness->objects().find<OutputProblems>()->any());
}

TEST_F(KickEvaluationTest, aFolderThatCannotBeIsAnErrorAtTheStart) {
  folder.write("KickEvaluation.yaml", "folder: " + folder / "file/in" + "\n");
  folder.write("file", "");
  test::ModuleHarness<KickEvaluation> bad({folder.path()});
  EXPECT_EQ(thrownBy([&] { bad.module(); }),
            folder / "KickEvaluation.yaml" + ":1: folder " + folder / "file/in" +
                ": cannot be written: Not a directory; choose another folder");
}

}  // namespace
}  // namespace plumbline
