#include "gap/diagnosis/PossibleCauses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class PossibleCausesTest : public ::testing::Test {
protected:
  Cause at(const char* id, const char* place, double value) const {
    const Effect* effect = findEffect(id);
    return {effect, findPlace(*effect, arm, place, ""), value, 0};
  }
  /// The variants of an effect at a place that are worth a look, a bit each.
  unsigned variants(const char* id, const char* place) const {
    const Cause wanted = at(id, place, 0);
    unsigned found = 0;
    for (const Cause& cause : possibleCauses(evaluator))
      if (cause.sameKind(wanted)) found |= 1u << static_cast<unsigned>(cause.variant);
    return found;
  }

  const Mechanism arm = twoJointArm();
  Plant plant = [this] {
    Plant p = nominalPlant(arm);
    p.joints[0].viscous += 0.5;
    p.joints[1].viscous += 0.5;
    return p;
  }();
  const Evidence evidence{{recorded(plant, armTrial(arm, 6), 5e-4, 3)}};
  Evaluator evaluator{arm, evidence};
};

TEST_F(PossibleCausesTest, aJointWithACauseDoesNotHuntBesides) {
  evaluator.setBase({});
  EXPECT_EQ(variants("backlash", "shoulder"), 3u);
  EXPECT_EQ(variants("backlash", "elbow"), 3u);
  evaluator.setBase({at("viscous_friction", "elbow", 0.3)});
  EXPECT_EQ(variants("backlash", "shoulder"), 3u);
  EXPECT_EQ(variants("backlash", "elbow"), 1u) << "the encoder where the model has it";
}

TEST_F(PossibleCausesTest, noCauseTwiceAtAPlace) {
  evaluator.setBase({at("viscous_friction", "elbow", 0.3)});
  EXPECT_EQ(variants("viscous_friction", "elbow"), 0u);
  EXPECT_EQ(variants("viscous_friction", "shoulder"), 1u);
}

}  // namespace
}  // namespace plumbline::gap
