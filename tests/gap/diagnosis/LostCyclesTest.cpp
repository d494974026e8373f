#include "gap/diagnosis/LostCycles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../Pendulum.h"
#include "../SquaresLeft.h"

namespace plumbline::gap {
namespace {

TEST(LostCyclesTest, noneWhereNoneIsLost) {
  const LostCycles found = findLostCycles(recordedWithout(std::vector<std::uint8_t>(600, 0)), {}, 1);
  EXPECT_EQ(found.found, 0u);
  EXPECT_EQ(found.share, 0);
  EXPECT_EQ(found.price, 0);
}

TEST(LostCyclesTest, severalInARowAreNoTrap) {
  std::vector<std::uint8_t> lost(600, 0);
  for (std::size_t k = 30; k + 6 < lost.size(); k += 40)
    std::fill_n(lost.begin() + static_cast<long>(k), 5, 1);
  const Evidence evidence = recordedWithout(lost);
  const std::vector<std::uint8_t> found = findLostCycles(evidence, {}, 1).cycles[0];
  EXPECT_LT(squaresWith(evidence, found), 1.1 * squaresWith(evidence, lost));
}

TEST(LostCyclesTest, noneThereWhereRepeatsAgreeWhateverElseIsOff) {
  Plant plant = nominalPlant(pendulum());
  plant.joints[0].viscous += 0.01;
  const Evidence evidence(pendulumRecordedTwice(plant, 0));
  const std::vector<std::uint8_t> none(evidence.trials()[0].cycles(), 0);
  ASSERT_GT(squaresWith(evidence, none), 5 * static_cast<double>(none.size()));
  EXPECT_EQ(findLostCycles(evidence, {}, 1).found, 0u);
}

}  // namespace
}  // namespace plumbline::gap
