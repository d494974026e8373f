#include "walking/estimation/ObservedStep.h"

#include <gtest/gtest.h>

namespace plumbline::walking {
namespace {

constexpr double dt = 0.02;

class StepRecorderTest : public testing::Test {
protected:
  /// So many cycles on a foot, which turns under the torso by so much in each.
  void stand(Support support, int cycles, double turn = 0) {
    state.support = support;
    for (int i = 0; i < cycles; ++i) {
      if (support != Support::both) state.foot[index(state.supportSide())].heading -= turn;
      recorder.add(state, {}, dt);
    }
  }
  StepRecorder recorder;
  WalkState state;
};

TEST_F(StepRecorderTest, aStepIsWhatLiesBetweenTwoChangesOfTheFoot) {
  stand(Support::left, 6, 0.01);
  EXPECT_EQ(recorder.take(), nullptr) << "it is not over";
  stand(Support::right, 1);
  const ObservedStep* const step = recorder.take();
  ASSERT_NE(step, nullptr);
  EXPECT_EQ(step->begin.support, Support::left);
  ASSERT_EQ(step->samples.size(), 5u);
  EXPECT_NEAR(step->samples.back().time, 5 * dt, 1e-12);
  EXPECT_NEAR(step->turnRate, 0.01 / dt, 1e-9);
  EXPECT_EQ(recorder.take(), nullptr) << "it was taken";
}

TEST_F(StepRecorderTest, onBothFeetThereIsNoStep) {
  stand(Support::both, 20);
  stand(Support::left, 6);
  EXPECT_EQ(recorder.take(), nullptr);
}

// A speed is seen over time: one sample behind the beginning, as of a foot that only touches, shows none.
TEST_F(StepRecorderTest, aTouchOfTheGroundIsNoStep) {
  stand(Support::left, 2);
  stand(Support::right, 3);
  EXPECT_EQ(recorder.take(), nullptr);
  stand(Support::left, 1);
  ASSERT_NE(recorder.take(), nullptr) << "two samples do";
}

TEST_F(StepRecorderTest, whatWasBegunIsForgottenAtAReset) {
  stand(Support::left, 6);
  recorder.reset();
  stand(Support::right, 1);
  EXPECT_EQ(recorder.take(), nullptr);
}

}  // namespace
}  // namespace plumbline::walking
