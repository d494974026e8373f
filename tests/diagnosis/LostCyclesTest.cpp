// Those of tests/gap/diagnosis/LostCyclesTest.cpp that take longer.
#include "gap/diagnosis/LostCycles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "gap/Pendulum.h"
#include "gap/SquaresLeft.h"

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

TEST(LostCyclesTest, thoseThatWereLostExplainTheRecording) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<std::uint8_t> lost = drawnLosses(600, 0.12, seed);
    const Evidence evidence = recordedWithout(lost);
    const LostCycles found = findLostCycles(evidence, {}, 1);
    EXPECT_NEAR(found.share, 0.12, 0.04) << seed;
    // Nothing that is at a price of 14 each explains it better, the truth neither.
    const auto price = [](const std::vector<std::uint8_t>& cycles) {
      return 14.0 * static_cast<double>(std::ranges::count(cycles, 1));
    };
    EXPECT_GT(squaresWith(evidence, std::vector<std::uint8_t>(600, 0)), 5000) << seed;
    EXPECT_LE(squaresWith(evidence, found.cycles[0]) + price(found.cycles[0]),
              squaresWith(evidence, lost) + price(lost))
        << seed;
  }
}

TEST(LostCyclesTest, whereAServoTakesLongToShowThem) {
  const Evidence evidence(pendulumRecordedTwice(nominalPlant(pendulum()), 0.08), NoiseFrom::itself);
  const LostCycles found = findLostCycles(evidence, {}, 1);
  EXPECT_NEAR(found.share, 0.08, 0.04);
  const std::vector<std::uint8_t> none(evidence.trials()[0].cycles(), 0);
  EXPECT_LT(squaresWith(evidence, found.cycles[0]), squaresWith(evidence, none) / 10);
}

}  // namespace
}  // namespace plumbline::gap
