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

TEST(TrackPicture, marksAFallOnceAndEveryTenSeconds) {
  std::vector<TrackPoint> track;
  for (int i = 0; i <= 250; ++i) track.push_back({0.1 * i, {0.01 * i, 0}, {1, 0}, i >= 100 && i < 150});
  const std::string svg = trackPicture(track, "fall");
  EXPECT_EQ(count(svg, ">fall</text>"), 2u);  // the fall and the title
  EXPECT_EQ(count(svg, " s</text>"), 3u);     // 0, 10 and 20 s
}

}  // namespace
