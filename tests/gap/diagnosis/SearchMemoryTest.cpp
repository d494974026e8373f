#include "gap/diagnosis/SearchMemory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "../TwoJointArm.h"
#include "gap/diagnosis/Diagnosis.h"

namespace plumbline::gap {
namespace {

class SearchMemoryTest : public ::testing::Test {
protected:
  SearchMemoryTest() { std::filesystem::remove(path); }
  ~SearchMemoryTest() override { std::filesystem::remove(path); }

  Evidence evidenceOf(std::uint64_t seed) const {
    Plant reality = nominalPlant(arm);
    reality.joints[1].coulomb = 0.08;
    return Evidence({recorded(reality, armTrial(arm, 3), 5e-4, seed)});
  }

  const Mechanism arm = twoJointArm();
  const std::string path = ::testing::TempDir() + "plumbline-search-memory";
};

TEST_F(SearchMemoryTest, aDiagnosisThatGoesOnFindsTheSame) {
  const Evidence evidence = evidenceOf(3);
  const auto run = [&](SearchMemory* memory, bool stop) {
    Evaluator fine(arm, evidence), coarse(arm, evidence);
    DiagnosisOptions options;
    options.memory = memory;
    options.progress = [&](const std::string&, double) {
      if (stop) throw std::runtime_error("it searches");
    };
    return diagnose(fine, coarse, options);
  };
  const Diagnosis whole = run(nullptr, false);
  {
    Evaluator fine(arm, evidence);
    SearchMemory memory(path, fine);
    EXPECT_EQ(memory.size(), 0u);
    run(&memory, false);
    EXPECT_GE(memory.size(), 1u);
  }
  Evaluator fine(arm, evidence);
  SearchMemory memory(path, fine);
  ASSERT_GE(memory.size(), 1u);
  const Diagnosis again = run(&memory, true);  // would throw if it searched
  ASSERT_EQ(again.findings.size(), whole.findings.size());
  EXPECT_EQ(again.findings[0].cause, whole.findings[0].cause);
  EXPECT_EQ(again.findings[0].probability, whole.findings[0].probability);
  EXPECT_EQ(again.gap.after, whole.gap.after);
  memory.forget();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(SearchMemoryTest, aFileOfOtherRunsOrADamagedOneIsNotTaken) {
  const Evidence one = evidenceOf(3), other = evidenceOf(4);
  Evaluator fine(arm, one);
  SearchMemory memory(path, fine);
  memory.keep({}, {});
  EXPECT_EQ(SearchMemory(path, fine).size(), 1u);
  EXPECT_EQ(SearchMemory(path, Evaluator(arm, other)).size(), 0u);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 3);
  EXPECT_EQ(SearchMemory(path, fine).size(), 0u);
}

}  // namespace
}  // namespace plumbline::gap
