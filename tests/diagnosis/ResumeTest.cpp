#include <gtest/gtest.h>

#include <filesystem>

#include "gap/TwoJointArm.h"
#include "gap/answer/Answer.h"
#include "gap/diagnosis/EvidenceMark.h"
#include "gap/diagnosis/Search.h"

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

  void expectTheSameAfterAKillAtEverySearch(const Evidence& evidence, const char* within) {
    std::size_t searches = 0;
    const std::string whole = answer(evidence, 0, &searches);
    ASSERT_NE(whole.find(within), std::string::npos) << whole.substr(0, 2000);
    ASSERT_GE(searches, 2u);
    // Killed at each search in turn, and gone on with every time.
    std::filesystem::remove(path);
    for (std::size_t n = 1; n <= searches; ++n) {
      try {
        answer(evidence, n);
      } catch (const Killed&) {
      }
      EXPECT_EQ(SearchMemory(path, markOf(Evaluator(arm, evidence), {}), arm).size(), n);
    }
    EXPECT_TRUE(answer(evidence, 0) == whole) << "killed at each of " << searches << " searches";
  }

  const Mechanism arm = twoJointArm();
  const std::string path = ::testing::TempDir() + "plumbline-resume";
};

TEST_F(ResumeTest, withLostCommandsInTheBase) {
  expectTheSameAfterAKillAtEverySearch(evidenceWith({causeOfArm("viscous_friction", "elbow", 0.2)}, 0.12),
                                       "\"effect\": \"command_dropout\"");
}

TEST_F(ResumeTest, withTwoCausesAtJoints) {
  expectTheSameAfterAKillAtEverySearch(
      evidenceWith(
          {causeOfArm("viscous_friction", "elbow", 0.2), causeOfArm("coulomb_friction", "shoulder", 0.1)}, 0),
      "\"effect\": \"coulomb_friction\"");
}

}  // namespace
}  // namespace plumbline::gap
