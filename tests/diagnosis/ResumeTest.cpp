#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "gap/TwoJointArm.h"
#include "gap/answer/Answer.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/EvidenceMark.h"

namespace plumbline::gap {
namespace {

/// A diagnosis that ends at once when so many searches are stored, as a kill would end it.
struct Killed {};

class ResumeTest : public ::testing::Test {
protected:
  ResumeTest() { std::filesystem::remove(path); }
  ~ResumeTest() override { std::filesystem::remove(path); }

  /// An arm with these causes that loses a share of its commands.
  static Evidence evidenceWith(const Explanation& causes, double lostShare) {
    const Mechanism arm = twoJointArm();
    Random random(4);
    std::vector<std::uint8_t> lost(400, 0);
    for (auto& cycle : lost) cycle = random.uniform() < lostShare;
    ReplayOptions options;
    options.lostCycles = &lost;
    return Evidence{{recorded(plantOf(arm, causes), armTrial(arm, 4), 5e-4, 7, options)}};
  }

  /// The answer's bytes; searches: stored in the end. most: it is killed when it has stored so many; 0:
  /// never.
  std::string answer(const Evidence& evidence, std::size_t most, std::size_t* searches = nullptr) const {
    Evaluator fine(arm, evidence), coarse(arm, evidence, coarseSteps());
    DiagnosisOptions options;
    SearchMemory memory(path, markOf(fine, options), arm);
    options.memory = &memory;
    options.progress = [&](const std::string&, double) {
      if (most > 0 && memory.size() >= most) throw Killed();
    };
    const Diagnosis diagnosis = diagnose(fine, coarse, options);
    if (searches) *searches = memory.size();
    return answerJson({"arm", {}, ""}, diagnosis, fine);
  }

  /// step: from one search at which it is killed to the next.
  void expectTheSameAfterKills(const Evidence& evidence, std::size_t step, const char* within) {
    std::size_t searches = 0;
    const std::string whole = answer(evidence, 0, &searches);
    ASSERT_NE(whole.find(within), std::string::npos) << whole.substr(0, 2000);
    ASSERT_GE(searches, 2u);
    // Killed at those searches in turn, and gone on with every time.
    std::filesystem::remove(path);
    std::size_t kills = 0;
    for (std::size_t n = 1; n <= searches; n += step, ++kills) {
      try {
        answer(evidence, n);
      } catch (const Killed&) {
      }
      EXPECT_EQ(SearchMemory(path, markOf(Evaluator(arm, evidence), {}), arm).size(), n);
    }
    EXPECT_TRUE(answer(evidence, 0) == whole) << "killed at " << kills << " of " << searches << " searches";
  }

  const Mechanism arm = twoJointArm();
  const std::string path = ::testing::TempDir() + "plumbline-resume";
};

TEST_F(ResumeTest, withLostCommandsInTheBase) {
  const std::size_t step = std::getenv("PLUMBLINE_SLOW") ? 1 : 4;  // a search takes seconds
  expectTheSameAfterKills(evidenceWith({causeOfArm("viscous_friction", "elbow", 0.2)}, 0.12), step,
                          "\"effect\": \"command_dropout\"");
}

TEST_F(ResumeTest, withTwoCausesAtJoints) {
  expectTheSameAfterKills(
      evidenceWith(
          {causeOfArm("viscous_friction", "elbow", 0.2), causeOfArm("coulomb_friction", "shoulder", 0.1)}, 0),
      1, "\"effect\": \"coulomb_friction\"");
}

TEST_F(ResumeTest, aDiagnosisThatIsStoredWholeSearchesNoMore) {
  Plant reality = nominalPlant(arm);
  reality.joints[1].coulomb = 0.08;
  const Evidence evidence({recorded(reality, armTrial(arm, 3), 5e-4, 3)});
  const auto run = [&](SearchMemory* memory, bool stop) {
    Evaluator fine(arm, evidence), coarse(arm, evidence);
    DiagnosisOptions options;
    options.memory = memory;
    options.progress = [&](const std::string&, double) {
      if (stop) throw Killed();
    };
    return diagnose(fine, coarse, options);
  };
  const Diagnosis whole = run(nullptr, false);
  {
    SearchMemory memory(path, "mark", arm);
    EXPECT_EQ(memory.size(), 0u);
    run(&memory, false);
    EXPECT_GE(memory.size(), 1u);
  }
  SearchMemory memory(path, "mark", arm);
  ASSERT_GE(memory.size(), 1u);
  const Diagnosis again = run(&memory, true);  // would throw if it searched
  ASSERT_EQ(again.findings.size(), whole.findings.size());
  EXPECT_EQ(again.findings[0].cause, whole.findings[0].cause);
  EXPECT_EQ(again.findings[0].probability, whole.findings[0].probability);
  EXPECT_EQ(again.gap.after, whole.gap.after);
  memory.forget();
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace plumbline::gap
