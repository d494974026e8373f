#include "gap/diagnosis/HoldHint.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

/// A smooth motion, recorded with commands that are held or move between the cycles.
Trial logged(bool linear) {
  const Mechanism arm = twoJointArm();
  Trial trial = armTrial(arm, 6, 0);
  for (std::size_t k = 0; k < trial.cycles(); ++k)
    for (std::size_t j = 0; j < 2; ++j) trial.command[j][k] = 0.5 * std::sin((j ? 5 : 4) * trial.time[k]);
  trial.linearCommands = linear;
  trial = recorded(plantOf(arm, {causeOfArm("coulomb_friction", "elbow", 0.01)}), trial, 1e-4, 5);
  trial.linearCommands = false;
  return trial;
}

TEST(HoldHintTest, commandsThatMoveBetweenCyclesAreNoticed) {
  const std::string hint = holdHint({logged(true)});
  EXPECT_EQ(hint.substr(0, 89),
            "commands seem to move between the lines of these logs: then the nominal model is off by 0");
  EXPECT_NE(hint.find("; if the controller is faster than its log, use --hold linear"), std::string::npos);
}

TEST(HoldHintTest, thereIsNoneOfHeldCommandsOrOnesThatAreKnownToMove) {
  EXPECT_EQ(holdHint({logged(false)}), "");
  Trial known = logged(true);
  known.linearCommands = true;
  EXPECT_EQ(holdHint({known}), "");
  Trial standing = logged(true);
  standing.freeBase = true;
  EXPECT_EQ(holdHint({standing}), "");
}

}  // namespace
}  // namespace plumbline::gap
