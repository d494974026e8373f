// Those of tests/gap/diagnosis/LostCyclesTest.cpp that take longer.
#include "gap/diagnosis/LostCycles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "gap/SquaresLeft.h"
#include "gap/TwoJointArm.h"

namespace plumbline::gap {
namespace {

TEST(LostCyclesTest, noneWhereAnotherEffectMakesTheJointsLate) {
  // Each of them leaves more than thirty times the noise; all commands were acted on.
  for (const auto& [id, place, value] :
       {std::tuple{"command_delay", "*", 0.0237}, std::tuple{"viscous_friction", "elbow", 0.6},
        std::tuple{"profile_speed", "*", 1.0}, std::tuple{"coulomb_friction", "*", 0.4}}) {
    const Cause cause = causeOfArm(id, place, value);
    const Evidence evidence{{recorded(plantOf(twoJointArm(), {cause}), armTrial(twoJointArm(), 6), 5e-4, 7)}};
    EXPECT_GT(squaresWith(evidence, std::vector<std::uint8_t>(600, 0)), 900 * 600) << describe(cause);
    const LostCycles found = findLostCycles(evidence, {}, 1);
    EXPECT_EQ(found.found, 0U) << describe(cause);
    EXPECT_EQ(std::ranges::count(found.cycles[0], 1), 0) << describe(cause);
  }
}

}  // namespace
}  // namespace plumbline::gap
