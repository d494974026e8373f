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

}  // namespace
}  // namespace plumbline::gap
