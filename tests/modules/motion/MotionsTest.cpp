#include "modules/motion/Motions.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "math/Angle.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

class MotionsTest : public testing::Test {
protected:
  MotionsTest()
      : folder(fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder);
    fs::create_directories(folder / "motions");
  }
  ~MotionsTest() override { fs::remove_all(folder); }
  void put(const std::string& name, const std::string& text) {
    std::ofstream(folder / "motions" / (name + ".yaml")) << text;
  }
  std::vector<motion::KeyframeMotion> read(const RobotModel& robot) const {
    ConfigStore store({folder.string()});
    return readMotions(Config(store, "Any"), robot);
  }
  double firstPitch(const RobotModel& robot) const {
    return toDegrees(read(robot).at(0).keyframes.at(0).angles[headPitch]);
  }

  fs::path folder;
  RobotModel robot = simsparkRobot(0);
};

TEST_F(MotionsTest, areReadAnewWhereAFileHasChanged) {
  put("nod", "keyframes:\n  - {time: 0.2, HeadPitch: 10}\n");
  EXPECT_NEAR(firstPitch(robot), 10, 1e-12);
  EXPECT_NEAR(firstPitch(robot), 10, 1e-12);
  put("nod", "keyframes:\n  - {time: 0.2, HeadPitch: 12}\n");
  EXPECT_NEAR(firstPitch(robot), 12, 1e-12);
  put("bow", "mirror: nod\n");
  ASSERT_EQ(read(robot).size(), 2u);
  put("nod", "keyframes:\n  - {time: 0.2, HeadPitch: 14}\n");
  EXPECT_NEAR(firstPitch(robot), 14, 1e-12) << "the mirror image too";
  fs::remove(folder / "motions" / "bow.yaml");
  EXPECT_EQ(read(robot).size(), 1u);
}

TEST_F(MotionsTest, areReadAnewForAnotherRobot) {
  put("nod", "keyframes:\n  - {time: 0.2, HeadPitch: 10}\n");
  EXPECT_NO_THROW(read(robot));
  RobotModel stiff = robot;  // of the same name
  stiff.links[static_cast<std::size_t>(stiff.linkOfJoint[headPitch])].upper = 0.1;
  EXPECT_THROW(read(stiff), ConfigurationError);
  EXPECT_NO_THROW(read(robot));
}

TEST_F(MotionsTest, aBrokenFileIsRefusedEachTime) {
  put("nod", "keyframes:\n  - {time: 0.2, HeadPitch: far}\n");
  for (int i = 0; i < 2; ++i) EXPECT_THROW(read(robot), ConfigurationError);
  put("nod", "keyframes:\n  - {time: 0.2, HeadPitch: 1}\n");
  EXPECT_NO_THROW(read(robot));
}

}  // namespace
}  // namespace plumbline
