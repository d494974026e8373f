#include "motion/SearchedKickPlace.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "math/Angle.h"
#include "support/Thrown.h"

namespace plumbline::motion {
namespace {

KeyframeMotion placedKick() {
  KeyframeMotion kick;
  kick.name = "some";
  kick.ball = Vec2(0.18, -0.05);
  kick.kick = KickEffect{.distance = 3, .direction = fromDegrees(2), .contact = 0.2};
  kick.keyframes.resize(2);
  kick.keyframes[0].seconds = 0.1;
  return kick;
}

TEST(SearchedKickPlace, beginsWhereTheKickIs) {
  const SearchedKickPlace place(placedKick());
  ASSERT_EQ(place.list().size(), 3u);
  EXPECT_EQ(place.list()[0].name, "ballX");
  EXPECT_DOUBLE_EQ(place.list()[0].start, 180);
  EXPECT_EQ(place.list()[1].name, "ballY");
  EXPECT_DOUBLE_EQ(place.list()[1].start, -50);
  EXPECT_EQ(place.list()[2].name, "direction");
  EXPECT_DOUBLE_EQ(place.list()[2].start, 2);
  for (const SearchedNumber& one : place.list()) {
    EXPECT_LT(one.lower, one.start) << one.name;
    EXPECT_GT(one.upper, one.start) << one.name;
  }
}

TEST(SearchedKickPlace, isRoundedAsItsFileAndLeavesTheKeyframes) {
  const KeyframeMotion motion =
      SearchedKickPlace(placedKick()).written(Eigen::Vector3d(171.6, -43.2, -1.2345));
  EXPECT_DOUBLE_EQ(motion.ball.x(), 0.172);
  EXPECT_DOUBLE_EQ(motion.ball.y(), -0.043);
  EXPECT_DOUBLE_EQ(motion.kick->direction, fromDegrees(-1.23));
  EXPECT_DOUBLE_EQ(motion.kick->distance, 3);
  ASSERT_EQ(motion.keyframes.size(), 2u);
  EXPECT_DOUBLE_EQ(motion.keyframes[0].seconds, 0.1);
}

TEST(SearchedKickPlace, aMotionThatIsNoKickIsRefused) {
  KeyframeMotion motion = placedKick();
  motion.kick.reset();
  EXPECT_EQ(thrownBy([&] { SearchedKickPlace{motion}; }), "some is no kick: it has no key kick");
}

}  // namespace
}  // namespace plumbline::motion
