#include "math/PlanarRoot.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(PlanarRoot, scaledRotationTakesThreeEvaluations) {
  const auto f = [](const Vec2& x) { return Vec2(1.7 * (Eigen::Rotation2Dd(0.8) * x) - Vec2(0.3, -2)); };
  const PlanarRoot root = findPlanarRoot(f, Vec2::Zero(), 1e-9, 10);
  EXPECT_TRUE(root.converged);
  EXPECT_EQ(root.evaluations, 3);
  EXPECT_NEAR((1.7 * (Eigen::Rotation2Dd(0.8) * root.x) - Vec2(0.3, -2)).norm(), 0, 1e-9);
}

TEST(PlanarRoot, learnsAGradientThatDiffersByDirection) {
  const auto f = [](const Vec2& x) {
    return Vec2(3 * x.x() + 0.4 * x.y() - 1, 0.2 * x.x() + 0.9 * x.y() + 2);
  };
  const PlanarRoot root = findPlanarRoot(f, Vec2::Zero(), 1e-9, 12);
  EXPECT_TRUE(root.converged);
  EXPECT_LE(root.evaluations, 7);
}

TEST(PlanarRoot, rootAtTheStartNeedsOneEvaluation) {
  const PlanarRoot root = findPlanarRoot([](const Vec2& x) { return x; }, Vec2::Zero(), 1e-9, 10);
  EXPECT_TRUE(root.converged);
  EXPECT_EQ(root.evaluations, 1);
}

TEST(PlanarRoot, tellsWhenThereIsNone) {
  const PlanarRoot root = findPlanarRoot([](const Vec2&) { return Vec2(1, 1); }, Vec2::Zero(), 1e-3, 10);
  EXPECT_FALSE(root.converged);
  EXPECT_TRUE(root.x.allFinite());
}

}  // namespace
}  // namespace plumbline
