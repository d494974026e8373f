#include "modules/modeling/others/RobotTrack.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline {
namespace {

RobotTrack::Parameters parameters() {
  RobotTrack::Parameters of;
  of.walkSeconds = 100;
  of.walkNoise = 1e-3;
  of.startSpeed = 0.5;
  return of;
}

TEST(RobotTrack, isLessSureOfAPlaceByWhatItsSpeedMayHaveBeen) {
  RobotTrack track(true, 3);
  track.see({1, 2}, 0.01 * Mat2::Identity(), 0, parameters());
  track.predict(2, parameters());
  // 0.1 m when it was seen, and 2 s at 0.5 m/s.
  EXPECT_NEAR(track.robot().covariance(0, 0), 0.01 + 1, 0.03);
  EXPECT_NEAR(track.robot().covariance(1, 1), 0.01 + 1, 0.03);
  EXPECT_EQ(track.robot().position, Vec2(1, 2));
}

TEST(RobotTrack, goesOnAtTheSpeedThatWasSeenWhichDiesAway) {
  RobotTrack::Parameters of = parameters();
  of.walkNoise = 0.8;
  RobotTrack track(false, 1);
  for (int i = 0; i <= 100; ++i) {
    track.see({0.01 * i, 0}, 1e-4 * Mat2::Identity(), 0.02 * i, of);
    track.predict(0.02, of);
  }
  EXPECT_NEAR(track.robot().velocity.x(), 0.5, 0.02);
  of.walkSeconds = 1;
  track.predict(1, of);
  EXPECT_NEAR(track.robot().velocity.x(), 0.5 * std::exp(-1), 0.02);
}

}  // namespace
}  // namespace plumbline
