#include "gap/blind/Make.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "gap/run/RunFile.h"

namespace plumbline::gap {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

BlindMakeOptions options(const std::string& engine, const std::string& folder, int jobs) {
  BlindMakeOptions o;
  o.draw.cases = 5;
  o.draw.seed = 3;
  o.robot = "xl330_pendulum";
  o.engine = engine;
  o.output = (fs::path(testing::TempDir()) / folder).string();
  o.jobs = jobs;
  fs::remove_all(o.output);
  return o;
}

TEST(BlindMake, BulletIsAnEngineWithEffectsOutsideTheLibraryToo) {
  const BlindMakeOptions one = options("bullet", "blind_one", 1), two = options("bullet", "blind_two", 2);
  const BlindSet set = makeBlind(one);
  EXPECT_EQ(set.engine, "bullet");
  makeBlind(two);
  ASSERT_EQ(set.cases.size(), 5U);
  int outside = 0;
  std::vector<RunWarning> warnings;
  for (const BlindCase& c : set.cases) {
    outside += c.kind == BlindKind::outside;
    EXPECT_EQ(c.kind != BlindKind::none, !c.effects.empty());
    for (const char* name : {"run1", "run5"}) {
      const fs::path run = fs::path(c.name) / name;
      EXPECT_GT(readRun((fs::path(one.output) / run).string(), warnings).size(), 700U);
      EXPECT_EQ(contents(fs::path(one.output) / run / "run.csv.gz"),
                contents(fs::path(two.output) / run / "run.csv.gz"))
          << "the same whatever jobs is";
    }
  }
  EXPECT_EQ(outside, 1);
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

TEST(BlindMake, LeavesNothingWhereAnEngineIsMissing) {
  BlindMakeOptions o = options(blindProgram, "blind_missing", 1);
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
