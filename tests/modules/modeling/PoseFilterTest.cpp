#include "modules/modeling/selflocator/PoseFilter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/SyntheticImage.h"

using namespace plumbline;
using namespace plumbline::test;

namespace {

/// A robot that wanders over the field, seen through SimSpark's noise and an odometry that is 2 % off.
class Wanderer {
public:
  explicit Wanderer(bool leftSide, std::uint64_t seed, const PoseFilter::Parameters& parameters = {})
      : leftSide(leftSide),
        filter(FieldMap(FieldSize{}, leftSide), parameters),
        image(seed),
        random(seed + 100) {}

  /// One cycle; maxLandmarks are left in the image.
  void step(std::size_t maxLandmarks = 8) {
    double turn = 0.5 * std::sin(cycle * 0.003) + 0.2 * std::sin(cycle * 0.0171);
    if (std::abs(truth.x()) > 13 || std::abs(truth.y()) > 8.5) {
      const double toCentre = std::atan2(-truth.y(), -truth.x());
      turn = normalizeAngle(toCentre - truth.heading) > 0 ? 1 : -1;
    }
    const Pose2 step = noisy(Pose2(0.012, 0, turn * 0.02), 0.004, 0);
    truth = truth * step;
    filter.predict(noisy(Pose2(1.02 * step.x(), step.y(), step.heading), 0.0007, 0.00003));
    if (cycle++ % 3 != 0) return;
    const Pose3 head = headOverGround(std::sin(cycle * 0.05), 0.2 + 0.2 * std::sin(cycle * 0.02));
    const Pose2 onServer = leftSide ? truth : Pose2(0, 0, pi) * truth;
    // The head's tilt is known to a tenth of a degree only.
    const Pose2 tilt = noisy(Pose2(), 0.002, 0);
    const Pose3 wobble = rotationY(tilt.x()) * rotationX(tilt.y());
    FieldView view = fieldView(image.see(onField(onServer) * wobble * head), head);
    if (view.landmarks.size() > maxLandmarks) view.landmarks.resize(maxLandmarks);
    filter.update(view);
  }
  double error() const { return (filter.estimate().pose.position - truth.position).norm(); }
  double headingError() const {
    return std::abs(toDegrees(normalizeAngle(filter.estimate().pose.heading - truth.heading)));
  }
  bool lost() const { return error() > 0.1 || headingError() > 2; }
  /// Cycles until it is no longer lost, at most limit.
  int cyclesToFind(int limit, std::size_t maxLandmarks = 8) {
    int cycles = 0;
    for (; cycles < limit && lost(); ++cycles) step(maxLandmarks);
    return cycles;
  }

  bool leftSide;
  PoseFilter filter;
  SyntheticImage image;
  Random random;
  Pose2 truth{-5, 2, 0.3};
  int cycle = 0;

private:
  Pose2 noisy(Pose2 pose, double way, double turn) {
    const double x = random.gaussian(), y = random.gaussian(), t = random.gaussian();
    return Pose2(pose.x() + way * x, pose.y() + way * y, pose.heading + turn * t);
  }
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

TEST(PoseFilter, staysWithinAFewMillimetresFromBothSides) {
  for (const bool leftSide : {true, false}) {
    Wanderer robot(leftSide, 11);
    EXPECT_FALSE(robot.filter.estimate().valid);
    std::vector<double> errors, headingErrors;
    for (int i = 0; i < 3000; ++i) {
      robot.step();
      ASSERT_TRUE(robot.filter.estimate().valid);
      if (i < 10) continue;
      errors.push_back(robot.error());
      headingErrors.push_back(robot.headingError());
    }
    EXPECT_LT(quantile(errors, 0.5), 0.008);
    EXPECT_LT(quantile(errors, 0.95), 0.015);
    EXPECT_LT(quantile(errors, 1), 0.04);
    EXPECT_LT(quantile(headingErrors, 0.5), 0.03);
    EXPECT_LT(quantile(headingErrors, 0.95), 0.1);
    EXPECT_LT(robot.filter.resets(), 60) << "of 30 particles in 1000 images";
  }
}

TEST(PoseFilter, oneLandmarkAtATimeIsEnoughToStartAndToStay) {
  Wanderer robot(true, 12);
  for (int i = 0; i < 150; ++i) robot.step(1);
  std::vector<double> errors;
  for (int i = 0; i < 1500; ++i) {
    robot.step(1);
    errors.push_back(robot.error());
  }
  EXPECT_LT(quantile(errors, 0.5), 0.02);
  EXPECT_LT(quantile(errors, 0.95), 0.05);
}

// With equal rates no later image gives poses: what fits has to be chosen among those of the first one. That
// shows one landmark and a line, which some places of the field have in common.
TEST(PoseFilter, whatFitsIsCopiedAndTheRestIsForgotten) {
  PoseFilter::Parameters parameters;
  parameters.fastRate = parameters.slowRate;
  int ambiguous = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Wanderer robot(true, seed, parameters);
    Random random(seed);
    const double x = random.uniform(-13, 13), y = random.uniform(-8, 8);
    robot.truth = Pose2(x, y, random.uniform(-pi, pi));
    while (robot.filter.believed().empty()) robot.step(1);
    double worst = 0, best = 100;
    for (const PoseFilter::Particle& particle : robot.filter.believed()) {
      const double error = (particle.belief.pose.position - robot.truth.position).norm();
      worst = std::max(worst, error);
      best = std::min(best, error);
    }
    if (worst < 3 || best > 0.3) continue;
    ++ambiguous;
    for (int i = 0; i < 150; ++i) robot.step();
    EXPECT_EQ(robot.filter.resets(), 0);
    EXPECT_LT(robot.error(), 0.1) << "seed " << seed;
  }
  EXPECT_GE(ambiguous, 5);
}

TEST(PoseFilter, findsItselfAfterBeingCarriedAway) {
  Wanderer robot(true, 13);
  Random random(9);
  for (int trial = 0; trial < 10; ++trial) {
    for (int i = 0; i < 200; ++i) robot.step();
    EXPECT_LT(robot.error(), 0.05);
    const double x = random.uniform(-14, 14), y = random.uniform(-9, 9);
    robot.truth = Pose2(x, y, random.uniform(-pi, pi));
    EXPECT_LE(robot.cyclesToFind(200), 25) << "trial " << trial;
  }
  EXPECT_GT(robot.filter.resets(), 0);
}

// A robot is beamed as soon as it is connected: the first image shows where it hung before.
TEST(PoseFilter, findsItselfWhenCarriedAwayAfterTheFirstImage) {
  Wanderer robot(true, 18);
  for (int i = 0; i < 3; ++i) robot.step();
  robot.truth = Pose2(-3, 1, 0.4);
  EXPECT_LE(robot.cyclesToFind(200), 12);
}

TEST(PoseFilter, findsItselfEvenIfNoLandmarkWasInViewForLong) {
  Wanderer robot(true, 19);
  for (int i = 0; i < 100; ++i) robot.step();
  robot.truth = Pose2(-9, -5, 2);
  for (int i = 0; i < 1000; ++i) robot.step(0);
  if (!robot.lost()) GTEST_SKIP() << "lines sufficed";
  EXPECT_LE(robot.cyclesToFind(200), 25);
}

TEST(PoseFilter, findsItselfAfterBeingCarriedAwayWithOneLandmarkInView) {
  Wanderer robot(true, 14);
  for (int i = 0; i < 200; ++i) robot.step(1);
  robot.truth = Pose2(5, -3, 2);
  EXPECT_LE(robot.cyclesToFind(500, 1), 150);
  for (int i = 0; i < 100; ++i) robot.step(1);
  EXPECT_LT(robot.error(), 0.05);
}

TEST(PoseFilter, withoutImagesItGrowsUncertainAndInvalid) {
  Wanderer robot(true, 15);
  for (int i = 0; i < 50; ++i) robot.step();
  const double before = robot.filter.estimate().positionDeviation;
  for (int i = 0; i < 2000; ++i) robot.filter.predict(Pose2(0.01, 0, 0));
  EXPECT_GT(robot.filter.estimate().positionDeviation, 5 * before);
  for (int i = 0; i < 300; ++i) robot.filter.predict(Pose2(0.01, 0, 0), true);
  EXPECT_FALSE(robot.filter.estimate().valid);
}

TEST(PoseFilter, sameSeedSameBytes) {
  Wanderer a(true, 16), b(true, 16);
  for (int i = 0; i < 300; ++i) {
    if (i == 150) a.truth = b.truth = Pose2(3, 3, 3);
    a.step();
    b.step();
    ASSERT_EQ(a.filter.estimate().pose.position, b.filter.estimate().pose.position);
    ASSERT_EQ(a.filter.estimate().pose.heading, b.filter.estimate().pose.heading);
  }
}

TEST(PoseFilter, resetForgets) {
  Wanderer robot(true, 17);
  for (int i = 0; i < 10; ++i) robot.step();
  EXPECT_TRUE(robot.filter.estimate().valid);
  robot.filter.reset();
  EXPECT_FALSE(robot.filter.estimate().valid);
  robot.filter.predict(Pose2());
  EXPECT_FALSE(robot.filter.estimate().valid);
}

}  // namespace
