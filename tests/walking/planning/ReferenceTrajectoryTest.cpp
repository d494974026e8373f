#include "walking/planning/ReferenceTrajectory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "walking/model/LinearInvertedPendulum.h"

namespace plumbline::walking {
namespace {

constexpr double height = 0.25;
const double naturalRate = std::sqrt(9.81 / height);  // of the pendulum [1/s]

TEST(ReferenceTrajectory, onTheSpotIsTheClosedForm) {
  const LinearInvertedPendulum model(height);
  const Gait gait{.stepDuration = 0.2, .feetDistance = 0.12};
  const ReferenceTrajectory reference = findReferenceTrajectory(model, gait);
  // Swinging between the feet: v = d k tanh(k T / 2), k the natural rate, towards the foot that begins to
  // carry.
  const double v = 0.06 * naturalRate * std::tanh(naturalRate * 0.1);
  EXPECT_NEAR(reference.begin[0].velocity.y(), v, 1e-4);
  EXPECT_NEAR(reference.begin[1].velocity.y(), -v, 1e-4);
  EXPECT_NEAR(reference.begin[0].velocity.x(), 0, 1e-9);
}

class ReferenceTrajectoryOf : public testing::TestWithParam<Gait> {};

TEST_P(ReferenceTrajectoryOf, repeatsItselfAndWalksAtTheSpeed) {
  const Gait gait = GetParam();
  const LinearInvertedPendulum model(height, gait.copOffset);
  const ReferenceTrajectory reference = findReferenceTrajectory(model, gait);
  EXPECT_LE(reference.iterations, 5);
  EXPECT_LE(reference.error, 1e-3);

  WalkState state = reference.begin[0];
  Pose2 walked;
  for (const int foot : {0, 1}) {
    const auto support = static_cast<std::size_t>(foot);
    const Pose2 before = state.foot[support];
    state = model.predict(state, reference.action[support]);
    walked = walked * before * state.foot[support].inverse();
  }
  EXPECT_NEAR((state.velocity - reference.begin[0].velocity).norm(), 0, 1e-3);
  EXPECT_NEAR((state.foot[0].position - reference.begin[0].foot[0].position).norm(), 0, 1e-9);
  EXPECT_NEAR(walked.heading, gait.turn * 2 * gait.stepDuration, 1e-9);
  if (gait.turn == 0) {
    EXPECT_NEAR((walked.position / (2 * gait.stepDuration) - gait.velocity).norm(), 0, 2e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Gaits, ReferenceTrajectoryOf,
                         testing::Values(Gait{}, Gait{.velocity = Vec2(0.8, 0)},
                                         Gait{.velocity = Vec2(-0.4, 0)}, Gait{.velocity = Vec2(0.2, 0.3)},
                                         Gait{.turn = 1.5}, Gait{.turn = -2.5},
                                         Gait{.velocity = Vec2(0.5, -0.2), .turn = 1.8},
                                         Gait{.velocity = Vec2(0.6, 0.1),
                                              .turn = -1,
                                              .stepDuration = 0.12,
                                              .copOffset = Vec2(0.01, -0.01)},
                                         Gait{.velocity = Vec2(0.3, 0), .turn = 0.8, .stepDuration = 0.5}));

TEST(ReferenceTrajectory, feetOnlyTurnOutwardsAndNeverCross) {
  const LinearInvertedPendulum model(height);
  for (const double turn : {-2.0, 2.0})
    for (const double sideways : {-0.4, 0.4}) {
      const Gait gait{.velocity = Vec2(0.3, sideways), .turn = turn, .feetDistance = 0.1};
      WalkState state = findReferenceTrajectory(model, gait).begin[0];
      const ReferenceTrajectory reference = findReferenceTrajectory(model, gait);
      for (const int foot : {0, 1, 0, 1}) {
        state = model.predict(state, reference.action[static_cast<std::size_t>(foot)]);
        EXPECT_GE(state.foot[0].heading, -1e-9);
        EXPECT_LE(state.foot[1].heading, 1e-9);
        EXPECT_GE((state.foot[1].inverse() * state.foot[0]).y(), 0.08) << "as wide as a foot";
      }
    }
}

TEST(Arc, quarterCircle) {
  const Pose2 end = arc(Vec2(1, 0), pi / 2, 1);
  EXPECT_NEAR(end.x(), 2 / pi, 1e-12);
  EXPECT_NEAR(end.y(), 2 / pi, 1e-12);
  EXPECT_NEAR(end.heading, pi / 2, 1e-12);
}

}  // namespace
}  // namespace plumbline::walking
