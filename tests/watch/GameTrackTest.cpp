#include "watch/GameTrack.h"

#include <gtest/gtest.h>

#include <sstream>

namespace plumbline::watch {
namespace {

std::string contentOf(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(GameTrackTest, writesBallAndPlayersTwiceASecondWhileTheClockRuns) {
  const std::string file = testing::TempDir() + "track.csv";
  simspark::SceneState scene;
  scene.playMode = "PlayOn";
  scene.ball = Vec3(1, 2, 0.04);
  simspark::SceneRobot& robot = scene.robots.emplace_back();
  robot.side = simspark::TeamSide::right;
  robot.unum = 4;
  robot.T_world_torso.translation() = Vec3(-3, 0.5, 0.4);
  scene.robots.emplace_back();  // one without a team
  {
    GameTrack track(file);
    for (int i = 0; i < 8; ++i) {
      scene.time = 0.1 * (i + 1);
      track.observe(scene);
      track.observe(scene);  // the clock stands
    }
  }
  EXPECT_EQ(
      contentOf(file),
      "time,side,number,x,y,up,mode\n0.10,ball,0,1.00,2.00,0,PlayOn\n0.10,right,4,-3.00,0.50,1.00,PlayOn\n"
      "0.50,ball,0,1.00,2.00,0,PlayOn\n0.50,right,4,-3.00,0.50,1.00,PlayOn\n");
}

TEST(GameTrackTest, aFileThatCannotBeWrittenIsAnError) {
  try {
    GameTrack track("/nowhere/track.csv");
    FAIL() << "nothing thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot write /nowhere/track.csv: No such file or directory");
  }
}

}  // namespace
}  // namespace plumbline::watch
