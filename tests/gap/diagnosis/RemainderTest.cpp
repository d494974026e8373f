#include "gap/diagnosis/Remainder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../LegOnItsFoot.h"
#include "gap/diagnosis/GapMeter.h"

namespace plumbline::gap {
namespace {

/// A leg whose knee reads an angle too much where it hangs, and another one on its foot [rad].
struct Leg {
  Leg(double hanging, double floating) {
    for (const bool feet : {false, true}) {
      trials.push_back(recorded(nominalPlant(leg), legTrial(feet), 5e-4, 3));
      for (double& value : trials.back().signals[0].values) value += feet ? floating : hanging;
    }
  }
  Mechanism leg = legOnItsFoot();
  std::vector<Trial> trials;
};

/// What the nominal model leaves of such a leg.
struct Left {
  Left(double hanging, double floating) : off(hanging, floating) {}
  Remainder of(double worstBefore) const { return {evaluator, worstBefore}; }
  Leg off;
  const Evidence evidence{off.trials};
  const Evaluator evaluator{off.leg, evidence};
};

TEST(RemainderTest, theSameGapCountsMoreOnAFixedBase) {
  const Left left(0.02, 0.02);
  const Remainder remainder = left.of(0);
  ASSERT_GT(gapOnFixedBase(left.evaluator), 5);
  EXPECT_GT(remainder.unaccountedOnFixedBase() / gapOnFixedBase(left.evaluator),
            1.2 * remainder.unaccountedOnFloatingBase() / gapOnFloatingBase(left.evaluator));
  EXPECT_EQ(remainder.unaccounted(),
            std::max(remainder.unaccountedOnFixedBase(), remainder.unaccountedOnFloatingBase()));
}

TEST(RemainderTest, itGrowsWithTheGapThatIsLeft) {
  const Left one(0.02, 0), two(0.04, 0);
  EXPECT_NEAR(two.of(0).unaccounted() / one.of(0).unaccounted(), 2, 0.1);
  EXPECT_LT(one.of(0).unaccountedOnFloatingBase(), one.of(0).unaccountedOnFixedBase() / 10);
}

TEST(RemainderTest, ofALargeGapAPartMayStay) {
  const Left left(0.02, 0);
  const double gap = worstGap(left.evaluator, false).size;
  const Remainder nothingExplained = left.of(gap), nearlyAllExplained = left.of(100 * gap);
  EXPECT_GT(nothingExplained.unaccounted(), 1);
  EXPECT_FALSE(nothingExplained.mayRemain());
  EXPECT_FALSE(nothingExplained.little());
  EXPECT_LT(nearlyAllExplained.unaccounted(), 1);
  EXPECT_TRUE(nearlyAllExplained.mayRemain());
  EXPECT_TRUE(nearlyAllExplained.little());
  // A tenth of it is no reason to look again, but too much to be the whole explanation.
  EXPECT_TRUE(left.of(10 * gap).mayRemain());
  EXPECT_GT(left.of(10 * gap).unaccounted(), 1);
}

TEST(RemainderTest, onTheFeetOnlySensorsAreLookedAtWithinWhatContactsDo) {
  const Left clean(0, 0), hanging(0.02, 0), floating(0, 0.02);
  EXPECT_TRUE(clean.of(10).onlyOfSensors());
  EXPECT_FALSE(hanging.of(0).onlyOfSensors());
  EXPECT_FALSE(floating.of(0).onlyOfSensors());
  EXPECT_GT(floating.of(0).unaccountedOnFloatingBase(), 1);
}

}  // namespace
}  // namespace plumbline::gap
