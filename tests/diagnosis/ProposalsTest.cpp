#include "gap/diagnosis/Proposals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "gap/TwoJointArm.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/PossibleCauses.h"

namespace plumbline::gap {
namespace {

class ProposalsTest : public ::testing::Test {
protected:
  /// The arm's recording without these cycles' commands, with these causes in it.
  static Evidence recordedWith(const Explanation& causes, double lostShare) {
    const Mechanism arm = twoJointArm();
    Random random(4);
    std::vector<std::uint8_t> lost(400, 0);
    for (auto& cycle : lost) cycle = random.uniform() < lostShare;
    ReplayOptions options;
    options.lostCycles = &lost;
    return Evidence{{recorded(plantOf(arm, causes), armTrial(arm, 4), 5e-4, 7, options)}};
  }
  void look(const Evidence& evidence) {
    fine = std::make_unique<Evaluator>(arm, evidence);
    coarse = std::make_unique<Evaluator>(arm, evidence, coarseSteps());
    fine->setBase({});
    proposals = std::make_unique<Proposals>(*fine, *coarse, options);
  }
  static bool has(const std::vector<FittedCause>& list, const char* id) {
    return std::ranges::any_of(list, [&](const FittedCause& c) { return c.cause.effect->id == id; });
  }

  const Mechanism arm = twoJointArm();
  const DiagnosisOptions options;
  std::unique_ptr<Evaluator> fine, coarse;
  std::unique_ptr<Proposals> proposals;
};

TEST_F(ProposalsTest, theMostProbableFirst) {
  const Evidence evidence = recordedWith({causeOfArm("viscous_friction", "elbow", 0.2)}, 0);
  look(evidence);
  const std::vector<FittedCause> all = proposals->find({.stage = "first"});
  ASSERT_GT(all.size(), 5u);
  EXPECT_EQ(all[0].cause.effect->id, "viscous_friction");
  EXPECT_EQ(all[0].cause.place.at, "elbow");
  EXPECT_NEAR(all[0].cause.value, 0.2, 0.01);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i - 1].fit.judging, all[i].fit.judging) << i;
  const std::vector<FittedCause> sensors = proposals->find({.stage = "first", .onlySensors = true});
  for (const FittedCause& candidate : sensors) EXPECT_TRUE(ofSensor(candidate.cause));
  EXPECT_LT(sensors.size(), all.size());
}

TEST_F(ProposalsTest, lostCommandsWhereTheyAreAskedFor) {
  const Evidence evidence = recordedWith({}, 0.15);
  look(evidence);
  const std::string path = ::testing::TempDir() + "proposals-memory";
  std::filesystem::remove(path);
  SearchMemory memory(path, "mark", arm);
  EXPECT_FALSE(
      has(proposals->find({.stage = "first", .lostCommands = false, .memory = &memory}), "command_dropout"));
  EXPECT_EQ(memory.size(), 0u) << "a narrower look must not pass for the whole";
  const std::vector<FittedCause> all = proposals->find({.stage = "first", .memory = &memory});
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].cause.effect->id, "command_dropout");
  EXPECT_NEAR(all[0].cause.value, 0.15, 0.05);
  EXPECT_EQ(memory.size(), 1u);
  fine->setLostCycles({});
  EXPECT_EQ(proposals->find({.stage = "again", .memory = &memory})[0].cause, all[0].cause);
  EXPECT_FALSE(fine->lostCycles().empty()) << "the cycles are remembered with it";
  memory.forget();
}

TEST_F(ProposalsTest, coarseStepsWhereTheyTellTheSame) {
  const Evidence evidence = recordedWith({causeOfArm("viscous_friction", "elbow", 0.2)}, 0);
  look(evidence);
  EXPECT_EQ(&proposals->quickOn({}), coarse.get());
}

TEST_F(ProposalsTest, fineStepsWhereCoarseOnesAddMoreThanThereIsToExplain) {
  const Evidence evidence = recordedWith({}, 0);
  look(evidence);
  ReplayOptions longSteps;
  longSteps.step = 0.003;
  Evaluator rough(arm, evidence, longSteps);
  Proposals withRough(*fine, rough, options);
  const Evaluator& chosen = withRough.quickOn({});
  ASSERT_LE(rough.baseFit().fitting, 1.2 * fine->baseFit().fitting) << "close enough by its squares";
  ASSERT_GT(rough.baseFit().judging, fine->baseFit().judging + 1);
  EXPECT_EQ(&chosen, fine.get());
}

}  // namespace
}  // namespace plumbline::gap
