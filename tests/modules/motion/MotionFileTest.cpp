#include "modules/motion/MotionFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

class MotionFileTest : public testing::Test {
protected:
  MotionFileTest()
      : folder(fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    put("# nods\nkeyframes:\n  - {time: 0.2, HeadPitch: 10}  # down\n  - {time: 0.2, HeadPitch: 0}\n");
  }
  ~MotionFileTest() override { fs::remove_all(folder); }
  void put(const std::string& text) { std::ofstream(folder / "nod.yaml") << text; }
  std::string text() const {
    std::ifstream in(folder / "nod.yaml");
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string problemOf(const MotionDraft& draft) const {
    try {
      file().write(draft, robot);
      return "written";
    } catch (const std::exception& error) {
      const std::string what = error.what();
      return what.substr(what.rfind(folder.string(), 0) == 0 ? folder.string().size() + 1 : 0);
    }
  }
  MotionFile file() const { return {folder / "nod.yaml", {folder}}; }

  fs::path folder;
  RobotModel robot = simsparkRobot(0);
};

TEST_F(MotionFileTest, aChangedDraftIsWrittenAndReadBack) {
  MotionDraft draft = file().read(robot);
  EXPECT_EQ(draft.comment, "");
  ASSERT_EQ(draft.keyframes.size(), 2u);
  draft.keyframes[0].joints[0].degrees = 12.5;
  EXPECT_TRUE(file().write(draft, robot));
  EXPECT_EQ(text(),
            "# nods\nkeyframes:\n  - {time: 0.2, HeadPitch: 12.5}  # down\n  - {time: 0.2, HeadPitch: 0}\n");
  const MotionDraft after = file().read(robot);
  EXPECT_EQ(after.keyframes[0].joints[0].degrees, 12.5);
  EXPECT_NE(after.revision, draft.revision);
  EXPECT_FALSE(file().write(after, robot));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(MotionFileTest, anImpossibleMotionIsRefusedAndTheFileStays) {
  const std::string before = text();
  MotionDraft draft = file().read(robot);
  draft.keyframes[0].joints[0].degrees = 100;
  EXPECT_EQ(problemOf(draft),
            "nod.yaml:3: HeadPitch: 100 degrees is out of the limits -45 to 45 of HeadPitch in robot " +
                robot.name);
  draft = file().read(robot);
  draft.keyframes[0].time = -0.1;
  EXPECT_EQ(problemOf(draft), "nod.yaml: keyframe 1: the time is negative");
  draft = file().read(robot);
  draft.keyframes[1].joints[0].joint = "HeadRoll";
  EXPECT_EQ(problemOf(draft), "nod.yaml: keyframe 2: there is no joint \"HeadRoll\"");
  draft = file().read(robot);
  draft.keyframes.clear();
  EXPECT_EQ(problemOf(draft), "nod.yaml: a motion has one keyframe at least");
  EXPECT_EQ(text(), before);
}

TEST_F(MotionFileTest, whatSomebodyElseWroteMeanwhileIsNotOverwritten) {
  MotionDraft draft = file().read(robot);
  draft.keyframes[0].time = 0.3;
  const std::string theirs = "keyframes:\n  - {time: 1, HeadPitch: 5}\n";
  put(theirs);
  EXPECT_EQ(problemOf(draft), "nod.yaml was changed by somebody else; nothing is written");
  EXPECT_EQ(text(), theirs);
}

TEST_F(MotionFileTest, aFileThatCannotBeEditedSaysWhy) {
  put("mirror: other\n");
  std::ofstream(folder / "other.yaml") << "keyframes:\n  - {time: 1, HeadPitch: 5}\n";
  EXPECT_EQ(file().read(robot).comment,
            (folder / "nod.yaml").string() + ":1: this is the mirror image of other; edit that one");
  put("keyframes: 3\n");
  EXPECT_NE(file().read(robot).comment, "");
}

}  // namespace
}  // namespace plumbline
