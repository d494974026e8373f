#include "modules/modeling/selflocator/PoseBelief.h"

#include <gtest/gtest.h>

#include "math/Random.h"
#include "support/SyntheticImage.h"

using namespace plumbline;
using namespace plumbline::test;

namespace {

double distance(const Pose2& a, const Pose2& b) { return (a.position - b.position).norm(); }
double turn(const Pose2& a, const Pose2& b) { return std::abs(normalizeAngle(a.heading - b.heading)); }

TEST(PoseBelief, predictionMovesPoseAndCovarianceAsSamplesDo) {
  const Vec3 deviations(0.01, 0.02, 0.015);
  PoseBelief belief{Pose2(1, 2, 0.5), deviations.cwiseAbs2().asDiagonal()};
  const Pose2 start = belief.pose, step(0.3, -0.1, 0.4);
  PoseStep(step, Vec3::Zero()).apply(belief);
  EXPECT_LT(distance(belief.pose, start * step), 1e-12);
  Random random(2);
  Mat3 sum = Mat3::Zero();
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double x = random.gaussian(), y = random.gaussian(), t = random.gaussian();
    const Pose2 off(deviations.x() * x, deviations.y() * y, deviations.z() * t);
    const Pose2 local = belief.pose.inverse() * (start * off * step);
    const Vec3 v(local.x(), local.y(), local.heading);
    sum += v * v.transpose() / n;
  }
  EXPECT_LT((sum - belief.covariance).norm(), 0.05 * belief.covariance.norm());
}

TEST(PoseUpdate, exactImageGivesTheExactPose) {
  const FieldMap map(FieldSize{}, true);
  SyntheticImage image;
  const Pose2 truth(-4, 2.5, 0.3);
  const Pose3 head = headOverGround(0.2, 0.2);
  const FieldView view = fieldView(image.see(onField(truth) * head), head);
  ASSERT_GE(view.landmarks.size(), 2u);
  ASSERT_GE(view.lines.size(), 5u);
  PoseBelief belief{truth * Pose2(0.1, -0.08, 0.03), Mat3::Identity()};
  for (int i = 0; i < 3; ++i) {  // the step is linear: repeated it reaches the point itself
    belief.covariance = Vec3(0.04, 0.04, 0.01).asDiagonal();
    const Fit fit = PoseUpdate(map, view).apply(belief);
    EXPECT_EQ(fit.matchedLines, static_cast<int>(view.lines.size()));
  }
  EXPECT_LT(distance(belief.pose, truth), 1e-5);
  EXPECT_LT(turn(belief.pose, truth), 1e-6);
  EXPECT_LT(std::sqrt(belief.covariance(0, 0)), 0.01);
}

TEST(PoseUpdate, linesAloneCorrectAKnownPose) {
  const FieldMap map(FieldSize{}, true);
  SyntheticImage image;
  const Pose2 truth(0, -6, 1.6);
  const Pose3 head = headOverGround(0, 0.5);
  FieldView view = fieldView(image.see(onField(truth) * head), head);
  view.landmarks.clear();
  PoseBelief belief{truth * Pose2(0.1, 0.1, 0.05), Vec3(0.02, 0.02, 0.005).asDiagonal()};
  const Fit fit = PoseUpdate(map, view).apply(belief);
  EXPECT_GE(fit.matchedLines, 5);
  EXPECT_LT(distance(belief.pose, truth), 0.01);
  EXPECT_LT(turn(belief.pose, truth), 0.002);
}

TEST(PoseUpdate, errorIsThatOfTheNoiseAtTheRightPoseAndHugeAtAWrongOne) {
  const FieldMap map(FieldSize{}, true);
  SyntheticImage image(7);
  const Pose3 head = headOverGround(0, 0.2);
  double sum = 0, count = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 truth(-6 + 0.02 * i, 1, 0.01 * i);
    const FieldView view = fieldView(image.see(onField(truth) * head), head);
    PoseBelief belief{truth, Vec3(1e-4, 1e-4, 1e-5).asDiagonal()};
    const Fit fit = PoseUpdate(map, view).apply(belief);
    sum += fit.error;
    count += fit.measurements;
    PoseBelief wrong{truth * Pose2(3, 1, 1), Vec3(1e-4, 1e-4, 1e-5).asDiagonal()};
    const Fit bad = PoseUpdate(map, view).apply(wrong);
    EXPECT_GT(bad.error / std::max(1, bad.measurements), 50);
  }
  EXPECT_NEAR(sum / count, 0.85, 0.25);
}

}  // namespace
