#include "gap/blind/Make.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gap/effects/Effects.h"
#include "gap/run/RunFile.h"

namespace plumbline::gap {
namespace {

namespace fs = std::filesystem;

BlindMakeOptions options(const std::string& engine, const std::string& folder) {
  BlindMakeOptions o;
  o.draw.cases = 1;
  o.draw.seed = 3;
  o.robot = "xl330_pendulum";
  o.engine = engine;
  o.output = (fs::path(testing::TempDir()) / folder).string();
  o.jobs = 2;
  fs::remove_all(o.output);
  return o;
}

// A whole set is in tests/diagnosis.
TEST(BlindMake, AnswersAreSealedNextToTheRuns) {
  const BlindMakeOptions one = options("bullet", "blind_sealed");
  const BlindSet set = makeBlind(one);
  ASSERT_EQ(set.cases.size(), 1U);
  std::vector<RunWarning> warnings;
  for (const char* name : {"run1", "run5"})
    EXPECT_GT(readRun((fs::path(one.output) / set.cases[0].name / name).string(), warnings).size(), 700U);
  EXPECT_EQ(blindSetText(readSealed(one.output)), blindSetText(set));
}

TEST(BlindMake, NamesOfEngines) {
  for (const char* engine : {"replay", "bullet", "program"})
    EXPECT_NO_THROW(requireBlindEngine(engine)) << engine;
  try {
    requireBlindEngine("bulet");
    ADD_FAILURE() << "there is no such engine";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "there is no engine bulet; did you mean \"bullet\"?");
  }
}

// The program is no part of the tests (it needs MuJoCo), and refuses what it does not know in the middle of a
// set.
TEST(BlindMake, TheProgramKnowsEveryEffectThatIsDrawn) {
  std::ifstream file("tests/bench/mujoco/RealityEffect.cpp");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(text.empty());
  for (const Effect* effect : effects()) {
    if (effect->drawing.where == DrawRange::Where::nowhere) continue;
    EXPECT_NE(text.find("{\"" + std::string(effect->id) + "\","), std::string::npos) << effect->id;
  }
}

TEST(BlindMake, LeavesNothingWhereAnEngineIsMissing) {
  BlindMakeOptions o = options(blindProgram, "blind_missing");
  o.program = "no/such/program";
  try {
    makeBlind(o);
    ADD_FAILURE() << "there is no such program";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "no/such/program is not there: `make SimRelease-bench-mujoco` builds it, or --engine bullet "
                 "needs no other program");
  }
  EXPECT_FALSE(fs::exists(o.output));
}

}  // namespace
}  // namespace plumbline::gap
