#include "training/SprintCut.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "math/Types.h"
#include "training/SprintingWalk.h"

namespace plumbline::training {
namespace {

TEST(SprintCut, aCutSprintGoesTheSameWayLessFar) {
  const walking::WalkGaits all = sprintingWalk(), half = cutSprint(all, WalkTrialKind::forward, 0.5);
  EXPECT_NEAR(half.base.speed.maxForward, 0.4, 1e-12);
  EXPECT_EQ(half.base.speed.maxSideways, 0.3);
  for (const double speed : {0.1, 0.2, 0.3, 0.4})
    EXPECT_NEAR(half.at(Vec2(speed, 0), 0).step.height, all.at(Vec2(speed, 0), 0).step.height, 1e-12)
        << speed;
  EXPECT_NEAR(half.at(Vec2(0.4, 0), 0).step.height, 0.03, 1e-12);
}

TEST(SprintCut, nothingIsLeftOfASprintCutToNothing) {
  const walking::WalkGaits none = cutSprints(sprintingWalk(), 0);
  EXPECT_EQ(none.base.speed.maxForward, 0.2);
  EXPECT_EQ(none.base.speed.maxSideways, 0.1);
  EXPECT_EQ(none.corner[0].step.height, 0.02);
  EXPECT_THROW(cutSprint(none, WalkTrialKind::mixture, 1), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::training
