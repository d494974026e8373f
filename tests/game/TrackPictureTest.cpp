#include "game/TrackPicture.h"

#include <gtest/gtest.h>

using namespace plumbline;
using namespace plumbline::game;

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(TrackPicture, putsTheCentreOfTheFieldIntoTheMiddle) {
  const std::string svg = trackPicture({{0, {0, 0}, {15, 10}, false}}, "one point");
  // 30 pixels a metre, 1.2 m of margin: the centre at ((15 + 1.2) * 30, (10 + 1.2) * 30).
  EXPECT_NE(svg.find("points=\"486.0,336.0 \""), std::string::npos);
  EXPECT_NE(svg.find("points=\"936.0,36.0 \""), std::string::npos);
  EXPECT_NE(svg.find(">one point</text>"), std::string::npos);
}

TEST(TrackPicture, drawsTheFieldThatWasPlayedOn) {
  FieldSize small;
  small.length = 9;
  small.width = 6;
  const std::string svg = trackPicture({{0, {0, 0}, {1, 1}, false}}, "small", small);
  EXPECT_NE(svg.find("width=\"342\""), std::string::npos) << "(9 + 2 * 1.2) * 30";
  EXPECT_NE(svg.find("points=\"171.0,126.0 \""), std::string::npos);
}

TEST(TrackPicture, marksAFallOnceAndEveryTenSeconds) {
  std::vector<TrackPoint> track;
  for (int i = 0; i <= 250; ++i) track.push_back({0.1 * i, {0.01 * i, 0}, {1, 0}, i >= 100 && i < 150});
  const std::string svg = trackPicture(track, "fall");
  EXPECT_EQ(count(svg, ">fall</text>"), 2u);  // the fall and the title
  EXPECT_EQ(count(svg, " s</text>"), 7u);     // 0, 5, ... 25 s, and the legend
}

TEST(TrackPicture, aBeamIsNoWay) {
  const std::vector<TrackPoint> track = {{0, {0, 0}, {1, 0}, false},
                                         {0.1, {0.1, 0}, {1, 0}, false},
                                         {0.2, {-5, 0}, {1, 0}, false},
                                         {0.3, {-4.9, 0}, {1, 0}, false}};
  EXPECT_EQ(count(trackPicture(track, "beam"), "<polyline"), 3u);  // the robot's two ways and the ball's
}

TEST(TrackPicture, marksKicksNearTheRobot) {
  std::vector<TrackPoint> track;
  const auto roll = [&](int points, double speed) {
    for (int i = 0; i < points; ++i) {
      const double x = track.empty() ? 1 : track.back().ball.x() + 0.1 * speed;
      track.push_back({0.1 * static_cast<double>(track.size()), {x - 0.3, 0}, {x, 0}, false});
    }
  };
  roll(10, 0);
  roll(10, 0.5);  // dribbled
  roll(2, 2);     // kicked, in two steps
  roll(10, 4);
  roll(10, 1);
  roll(10, 3);
  ASSERT_EQ(kicksOf(track).size(), 2u);
  EXPECT_NEAR(kicksOf(track)[0].time, 1.9, 1e-9);
  EXPECT_NEAR(kicksOf(track)[1].time, 4.1, 1e-9);
  for (TrackPoint& point : track) point.robot = Vec2(-9, -9);
  EXPECT_TRUE(kicksOf(track).empty());
}

}  // namespace
