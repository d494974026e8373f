#include "gap/diagnosis/CauseSearch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../TwoJointArm.h"
#include "gap/diagnosis/PossibleCauses.h"

namespace plumbline::gap {
namespace {

std::vector<FittedCause> searched(const Mechanism& arm, const Evidence& evidence) {
  const Evaluator fine(arm, evidence), coarse(arm, evidence, coarseSteps());
  return search(fine, coarse, possibleCauses(fine), {});
}

TEST(CauseSearchTest, aStartThatIsFarTooStrongForAJointIsWeakened) {
  Mechanism arm = twoJointArm();
  Mechanism::Joint& elbow = arm.joints[1];
  arm.links[2].mass = 0.002;
  arm.links[2].inertia *= 0.01;
  elbow.maxTorque = 0.03;
  elbow.servo.kp = 0.4;
  elbow.servo.kd = 0.006;
  elbow.servo.armature = 1e-4;
  Plant plant = nominalPlant(arm);
  plant.joints[1].servo.armature = 1.4e-4;  // the weakest start of the library adds 30e-4
  const std::vector<FittedCause> found =
      searched(arm, Evidence({recorded(plant, armTrial(arm, 6), 5e-4, 3)}));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].cause.effect->id, "rotor_inertia");
  EXPECT_EQ(found[0].cause.place.at, "elbow");
  EXPECT_NEAR(found[0].cause.value, 4e-5, 2e-6);
}

TEST(CauseSearchTest, looksFirstAtARunThatShowsSomethingToFit) {
  const Mechanism arm = twoJointArm();
  Plant plant = nominalPlant(arm);
  plant.joints[1].coulomb = 0.05;
  std::vector<Trial> trials = {recorded(plant, armTrial(arm, 6, 0), 5e-4, 3),
                               recorded(plant, armTrial(arm, 6), 5e-4, 4)};
  // The first run rests; it is off most, but only in half seconds that nothing is fitted to.
  const std::vector<std::vector<SignalNoise>> noises(2, {{5e-4, 5e-4}, {5e-4, 5e-4}});
  const Evidence plain(trials);
  for (std::size_t k = 0; k < trials[0].cycles(); ++k)
    if (!Evidence::forFitting(plain.block(0, k))) trials[0].signals[1].values[k] += 0.1;
  const std::vector<FittedCause> found = searched(arm, Evidence(trials, noises));
  const auto friction = std::ranges::find_if(found, [&](const FittedCause& c) {
    return c.cause.effect->id == "coulomb_friction" && c.cause.place.at == "elbow";
  });
  ASSERT_NE(friction, found.end());
  EXPECT_NEAR(friction->cause.value, 0.05, 0.002);
}

}  // namespace
}  // namespace plumbline::gap
