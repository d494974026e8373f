#include "gap/record/Waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::gap {
namespace {

using Kind = Segment::Kind;

Segment segmentOf(Kind kind) {
  Segment segment;
  segment.kind = kind;
  segment.duration = 10;
  segment.cycles = 2;
  segment.fromHz = 0.5;
  segment.toHz = 5;
  segment.speed = 0.8;
  segment.seed = 3;
  return segment;
}

struct Seen {
  double most = 0, fastest = 0, hardest = 0;  ///< of value, speed and acceleration
};

Seen seenOf(const Segment& segment, double maxSpeed = 10, double maxAcceleration = 1e4) {
  const Wave wave(segment, 0, maxSpeed, maxAcceleration);
  constexpr double h = 1e-3;
  Seen seen;
  for (double t = h; t < segment.duration - h; t += h) {
    seen.most = std::max(seen.most, std::abs(wave(t)));
    const double before = wave(t - h), after = wave(t + h);
    if (std::abs(after - before) > 0.09) continue;  // a step
    seen.fastest = std::max(seen.fastest, std::abs(after - before) / (2 * h));
    seen.hardest = std::max(seen.hardest, std::abs(after - 2 * wave(t) + before) / (h * h));
  }
  return seen;
}

TEST(Waves, goToOneAndNotBeyondAndEndWhereTheyBegin) {
  for (const Kind kind :
       {Kind::triangle, Kind::chirp, Kind::steps, Kind::sine, Kind::bumps, Kind::multisine, Kind::fast}) {
    const Segment segment = segmentOf(kind);
    const Seen seen = seenOf(segment);
    EXPECT_LE(seen.most, 1.001) << static_cast<int>(kind);
    EXPECT_GT(seen.most, 0.9) << static_cast<int>(kind);
    EXPECT_NEAR(Wave(segment, 0, 10, 1e4)(segment.duration), 0, 1e-3) << static_cast<int>(kind);
  }
}

TEST(Waves, stepsAreToBothSidesWholeAndHalf) {
  const Segment segment = segmentOf(Kind::steps);
  const Wave wave(segment, 0, 10, 1e4);
  EXPECT_EQ(wave(1), 1);
  EXPECT_EQ(wave(3), -1);
  EXPECT_EQ(wave(5), 0.5);
  EXPECT_EQ(wave(7), -0.5);
  EXPECT_EQ(wave(9), 0);
}

TEST(Waves, aTriangleIsNearlyStraightBetweenItsTurns) {
  const Segment segment = segmentOf(Kind::triangle);
  const Wave wave(segment, 0, 10, 1e4);
  const double quarter = segment.duration / segment.cycles / 4;
  EXPECT_NEAR(wave(quarter), 1, 1e-9);
  EXPECT_NEAR(wave(quarter / 2), 0.5, 0.1);
  EXPECT_NEAR(wave(3 * quarter), -1, 1e-9);
}

TEST(Waves, fastMovesAreAsFastAsTheyMayBe) {
  const Segment segment = segmentOf(Kind::fast);
  const Seen slow = seenOf(segment, 5);
  EXPECT_LE(slow.fastest, 0.8 * 5 * 1.001);
  EXPECT_GT(slow.fastest, 0.8 * 5 * 0.99);
  const Seen heavy = seenOf(segment, 100, 30);
  EXPECT_LE(heavy.hardest, 30 * 1.01);
  EXPECT_GT(heavy.hardest, 30 * 0.97);
}

TEST(Waves, aFastMoveStepsBackATenthForATenthOfASecondOnceItIsThere) {
  const Segment segment = segmentOf(Kind::fast);
  const Wave wave(segment, 0, 10, 1e4);
  double back = 0;
  int steps = 0;
  for (double t = 1e-3; t < segment.duration; t += 1e-3) {
    const double jump = std::abs(wave(t)) - std::abs(wave(t - 1e-3));
    if (jump < -0.09) back = t;
    if (jump > 0.09) {
      EXPECT_NEAR(t - back, 0.1, 2.1e-3);
      EXPECT_NEAR(jump, 0.1, 1e-6);
      EXPECT_EQ(wave(back - 0.05), wave(back - 0.09)) << "it has rested there for a tenth of a second";
      EXPECT_NE(wave(back - 0.11), wave(back - 0.05));
      ++steps;
    }
  }
  EXPECT_GT(steps, 5);
}

}  // namespace
}  // namespace plumbline::gap
