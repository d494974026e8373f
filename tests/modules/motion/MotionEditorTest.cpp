#include "modules/motion/MotionEditor.h"

#include <gtest/gtest.h>

#include <memory>

#include "inspect/Inspector.h"
#include "modules/motion/MotionToPlay.h"
#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"

namespace plumbline {
namespace {

/// The editor with one motion, as a page sees it over the debug port.
class MotionEditorTest : public testing::Test {
protected:
  MotionEditorTest() {
    folder.write("motions/nod.yaml",
                 "keyframes:\n  - {time: 0.2, HeadPitch: 10}\n  - {time: 0.4, HeadPitch: -10}\n");
    harness.objects().set(agent);
    harness.objects().set(edited);
    harness.objects().set(std::make_shared<MotionToPlay>(MotionToPlay{"nod", false}));
    robot.model = simsparkRobot(0);
    robot.name = robot.model.name;
    harness.cycle();
    client = inspector.open([this](std::string_view line, bool) {
      said = line;
      return true;
    });
  }
  std::string ask(const std::string& command) {
    said.clear();
    inspector.command(client, command);
    harness.cycle();
    inspector.poll();
    return said;
  }
  /// Two keyframes, of which `first` to the last shall be played.
  std::string setDraft(const std::string& motion, int first, const std::string& degrees = "10") {
    return ask("set module:MotionEditor:draft {" + motion + " " + std::to_string(first) +
               " 1 {{-1 0.2 0 {{HeadPitch " + degrees + "}}} {-1 0.4 0 {{HeadPitch -10}}}}}");
  }

  test::ScratchFolder folder;
  std::shared_ptr<AgentDebug> agent = std::make_shared<AgentDebug>();
  std::shared_ptr<EditedMotion> edited = std::make_shared<EditedMotion>();
  test::ModuleHarness<MotionEditor> harness{{folder.path()}};
  RobotDescription& robot = harness.input<RobotDescription>();
  inspect::Inspector inspector{*agent};
  int client = 0;
  std::string said;
};

TEST_F(MotionEditorTest, aFileIsReadAndWrittenByItsName) {
  EXPECT_EQ(ask("get motion:nod.keyframes[0].joints[0].degrees"),
            "motion:nod.keyframes[0].joints[0].degrees 10.000000");
  EXPECT_EQ(edited->saved(), 0u);
  EXPECT_EQ(ask("set motion:nod.keyframes[0].joints[0].degrees 12.5"), "ok");
  EXPECT_EQ(folder.read("motions/nod.yaml"),
            "keyframes:\n  - {time: 0.2, HeadPitch: 12.5}\n  - {time: 0.4, HeadPitch: -10}\n");
  EXPECT_EQ(edited->saved(), 1u) << "who has read it reads it again";
}

TEST_F(MotionEditorTest, anImpossibleMotionIsRefusedAndTheFileStays) {
  const std::string before = folder.read("motions/nod.yaml");
  const std::string answer = ask("set motion:nod.keyframes[0].joints[0].degrees 100");
  EXPECT_NE(answer.find("HeadPitch: 100 degrees is out of the limits -45 to 45"), std::string::npos)
      << answer;
  EXPECT_EQ(folder.read("motions/nod.yaml"), before);
  EXPECT_EQ(edited->saved(), 0u);
}

TEST_F(MotionEditorTest, aDraftIsPlayedFromThePostureBeforeItAndWrittenNowhere) {
  const std::string before = folder.read("motions/nod.yaml");
  EXPECT_EQ(setDraft("nod", 1), "ok");
  const motion::KeyframeMotion draft = edited->draft();
  EXPECT_EQ(draft.name, EditedMotion::name);
  ASSERT_EQ(draft.keyframes.size(), 2u);
  EXPECT_EQ(draft.keyframes[0].seconds, 0.8) << "to the posture of keyframe 0";
  EXPECT_NEAR(draft.keyframes[0].angles[headPitch], fromDegrees(10), 1e-9);
  EXPECT_NEAR(draft.keyframes[1].angles[headPitch], fromDegrees(-10), 1e-9);
  EXPECT_EQ(folder.read("motions/nod.yaml"), before);
  EXPECT_EQ(ask("set module:MotionEditor:draft {\"\" 0 0 {}}"), "ok");
  EXPECT_TRUE(edited->draft().keyframes.empty());
}

TEST_F(MotionEditorTest, aDraftThatCannotBeIsRefusedAndTheLastOneStays) {
  setDraft("nod", 0);
  EXPECT_EQ(setDraft("bow", 0), "error: module:MotionEditor:draft: there is no motion bow");
  EXPECT_EQ(setDraft("nod", 2),
            "error: module:MotionEditor:draft: first and last must be keyframes of the draft");
  EXPECT_NE(setDraft("nod", 0, "100").find("out of the limits"), std::string::npos);
  EXPECT_EQ(edited->draft().keyframes.size(), 2u);
}

TEST_F(MotionEditorTest, tellsTheRobotAndTheMotionOfTheCommandLine) {
  EXPECT_EQ(ask("get module:MotionEditor:opened"), "module:MotionEditor:opened \"nod\"");
  EXPECT_EQ(ask("get module:MotionEditor:robot[0].name"), "module:MotionEditor:robot[0].name \"torso\"");
}

TEST_F(MotionEditorTest, untilTheRobotIsKnownNothingIsAnswered) {
  robot.name.clear();
  EXPECT_EQ(ask("get motion:nod.file"), "");
}

}  // namespace
}  // namespace plumbline
