#include "gap/blind/PlantedSet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "gap/blind/PlantedCase.h"
#include "gap/blind/RealArm.h"
#include "gap/run/RunCheck.h"
#include "gap/run/RunFile.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

using Recording = Run;  // gtest has a Run of its own in test classes

TEST(PlantedSet, kindsOfCases) {
  const std::vector<BlindCase> cases = drawPlantedCases(21, 5);
  ASSERT_EQ(cases.size(), 21U);
  std::set<std::string> names;
  std::size_t none = 0, two = 0, references = 0;
  for (const BlindCase& c : cases) {
    names.insert(c.name);
    none += c.kind == BlindKind::none;
    two += c.kind == BlindKind::mixture;
    references += c.reference;
    EXPECT_TRUE(c.kind == BlindKind::none || c.kind == BlindKind::mixture || c.kind == BlindKind::single);
  }
  EXPECT_EQ(names.size(), 21U);
  EXPECT_EQ(references, 1U);
  EXPECT_GE(none, 4U);
  EXPECT_GE(two, 2U);
}

TEST(PlantedSet, aCaseHasTheCausesOfItsKindAndTheyAreExact) {
  const PlantingBase base(realArm());
  EXPECT_GT(base.gap, 1e-4);
  for (const auto& [kind, count] : {std::pair{BlindKind::single, 1U}, std::pair{BlindKind::mixture, 2U}}) {
    BlindCase c;
    c.kind = kind;
    Random random(7);
    const RealRecordings with = plantCase(base, 0, random, c);
    ASSERT_EQ(c.effects.size(), count);
    EXPECT_GT(c.ratio, 1);
    EXPECT_FALSE(c.ratioChannel.empty());
    Explanation causes;
    for (const BlindEffect& e : c.effects)
      causes.push_back(
          {findEffect(e.effect), findPlace(*findEffect(e.effect), with.robot, e.at, e.axis), e.value});
    const double change = differenceOf(residualsOf(with, {}), base.nominal);
    EXPECT_GT(change, 0.1 * base.gap);
    EXPECT_LT(differenceOf(residualsOf({with.robot, with.runs}, causes), base.nominal), 0.06 * change);
  }
}

TEST(PlantedSet, nothingPlantedChangesNothing) {
  const PlantingBase base(realArm());
  BlindCase c;
  Random random(3);
  const RealRecordings with = plantCase(base, 0, random, c);
  EXPECT_TRUE(c.effects.empty());
  EXPECT_LT(differenceOf(residualsOf({with.robot, with.runs}, {}), base.nominal), 1e-6);
  EXPECT_NE(with.runs[0].t[0], 0) << "the clock begins elsewhere";
}

class PlantedFolder : public testing::Test {
protected:
  PlantedFolder() {
    for (const Recording& run : realArm().runs) writeRun(run, scratch / ("runs/" + run.folder));
  }
  PlantedSetOptions options(const std::string& output, int jobs = 1) const {
    PlantedSetOptions o;
    o.from = {scratch / "runs"};
    o.robot = "tests/e2e/gap/arm.json";
    o.cases = 3;
    o.seed = 9;
    o.output = scratch / output;
    o.jobs = jobs;
    return o;
  }
  const test::ScratchFolder scratch;
};

TEST_F(PlantedFolder, theSameSeedGivesTheSameBytesWhateverTheJobs) {
  std::vector<RunWarning> warnings;
  const BlindSet set = makePlantedSet(options("a"), warnings);
  makePlantedSet(options("b", 2), warnings);
  EXPECT_EQ(scratch.read("a/answers.sealed"), scratch.read("b/answers.sealed"));
  ASSERT_EQ(set.cases.size(), 3U);
  EXPECT_TRUE(set.fromRecordings());
  for (const BlindCase& c : set.cases)
    for (const char* file : {"/robot.json", "/run1/run.json", "/run1/run.csv.gz", "/run2/run.csv.gz"}) {
      EXPECT_FALSE(scratch.read("a/" + c.name + file).empty()) << file;
      EXPECT_EQ(scratch.read("a/" + c.name + file), scratch.read("b/" + c.name + file)) << file;
    }
  EXPECT_EQ(blindSetText(readSealed(scratch / "a")), blindSetText(set));
  EXPECT_EQ(std::ranges::count(set.cases, true, &BlindCase::reference), 1);
  // A case is used like any recording.
  const Mechanism robot = readMechanism(scratch / ("a/" + set.cases[0].name + "/robot.json"));
  EXPECT_EQ(readCheckedRun(scratch / ("a/" + set.cases[0].name + "/run1"), robot, warnings).size(),
            realArm().runs[1].size())
      << "by the names of the folders";
}

TEST_F(PlantedFolder, whatCannotBeIsRefusedInALine) {
  std::vector<RunWarning> warnings;
  PlantedSetOptions other = options("x");
  other.from = {scratch / "none"};
  EXPECT_NE(thrownBy([&] { makePlantedSet(other, warnings); }).find("is no folder"), std::string::npos);
  Recording feet = realArm().runs[0];
  feet.freeBase = true;
  writeRun(feet, scratch / "feet");
  other.from = {scratch / "feet"};
  EXPECT_NE(thrownBy([&] { makePlantedSet(other, warnings); }).find("its base is free"), std::string::npos);
  scratch.write("y/file", "");
  EXPECT_NE(thrownBy([&] { makePlantedSet(options("y"), warnings); }).find("exists already"),
            std::string::npos);
  EXPECT_EQ(scratch.read("x/answers.sealed"), "");
}

}  // namespace
}  // namespace plumbline::gap
