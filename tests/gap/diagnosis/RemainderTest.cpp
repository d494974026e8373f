#include "gap/diagnosis/Remainder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../StandingLeg.h"
#include "gap/diagnosis/GapMeter.h"

namespace plumbline::gap {
namespace {

/// A leg that is off by an angle where it hangs, and on its foot.
struct Leg {
  Leg(double held, double standing) {
    for (const bool feet : {false, true}) {
      trials.push_back(recorded(nominalPlant(leg), legTrial(feet), 5e-4, 3));
      for (double& value : trials.back().signals[0].values) value += feet ? standing : held;
    }
  }
  Mechanism leg = standingLeg();
  std::vector<Trial> trials;
};

TEST(RemainderTest, heldRunsMayLeaveLessThanThoseOnTheFeet) {
  const Leg one(0.02, 0);
  const Evidence evidence(one.trials);
  const Evaluator evaluator(one.leg, evidence);
  const double held = worstGap(evaluator, false).size;
  ASSERT_GT(held, 5);
  const Remainder small(evaluator, 0), large(evaluator, 100 * held);
  EXPECT_NEAR(small.unaccountedOnFixedBase(), held / 1.7, 1e-12);
  EXPECT_NEAR(large.unaccountedOnFixedBase(), 1 / 5.0, 1e-12);
  EXPECT_LT(small.unaccountedOnFloatingBase(), 0.5);
  EXPECT_EQ(small.unaccounted(), small.unaccountedOnFixedBase());
  EXPECT_FALSE(small.mayRemain());
  EXPECT_TRUE(large.mayRemain());
  EXPECT_FALSE(small.little());
  EXPECT_TRUE(large.little());
  EXPECT_FALSE(small.onlyOfSensors());
}

TEST(RemainderTest, onTheFeetOnlySensorsAreLookedAtWithinWhatContactsDo) {
  const Leg clean(0, 0), off(0, 0.02);
  const Evidence evidence(clean.trials), other(off.trials);
  const Evaluator evaluator(clean.leg, evidence), evaluatorOff(off.leg, other);
  EXPECT_TRUE(Remainder(evaluator, 10).onlyOfSensors());
  const Remainder left(evaluatorOff, 0);
  EXPECT_NEAR(left.unaccountedOnFloatingBase(), gapOnFloatingBase(evaluatorOff) / 2.5, 1e-12);
  EXPECT_GT(left.unaccountedOnFloatingBase(), 1);
  EXPECT_FALSE(left.onlyOfSensors());
}

}  // namespace
}  // namespace plumbline::gap
