#include "gap/diagnosis/Onset.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class OnsetTest : public ::testing::Test {
protected:
  static Cause heat(double value) { return causeOfArm("thermal_derating", "shoulder", value); }
  /// Ten seconds of sines.
  Evidence recordedWith(const Explanation& causes) const {
    Trial sines = armTrial(arm, 30, 0.5);
    sines.time.resize(1000);
    for (auto& command : sines.command) command.resize(1000);
    return Evidence{{recorded(plantOf(arm, causes), sines, 5e-4, 3)}};
  }

  const Mechanism arm = twoJointArm();
};

TEST_F(OnsetTest, theMomentTellsTheValueFromAnyStart) {
  const Evidence evidence = recordedWith({heat(0.01)});
  const Evaluator evaluator(arm, evidence);
  for (const double start : {0.0005, 0.2}) {
    const std::optional<Cause> found = causeByOnset(evaluator, heat(start));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value, 0.01, 1e-4);
  }
}

TEST_F(OnsetTest, nothingSetsInWhereNothingIsOff) {
  const Evidence evidence = recordedWith({});
  EXPECT_FALSE(causeByOnset(Evaluator(arm, evidence), heat(0.02)));
}

TEST_F(OnsetTest, whatIsOffFromTheStartDoesNotSetIn) {
  const Effect* gain = findEffect("servo_gain");
  const Evidence evidence = recordedWith({{gain, findPlace(*gain, arm, "shoulder", ""), 0.5, 0}});
  EXPECT_FALSE(causeByOnset(Evaluator(arm, evidence), heat(0.02)));
}

}  // namespace
}  // namespace plumbline::gap
