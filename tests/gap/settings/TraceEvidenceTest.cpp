#include "gap/settings/TraceEvidence.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "gap/LeagueTraces.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

TEST(TraceEvidence, HoldsOutWholeRobotTypesAndLeavesIdleWindowsOut) {
  const TraceEvidence evidence(leagueTraces(), 5, 16);
  for (const TraceWindow& window : evidence.windows()) {
    const int type = *evidence.traces()[window.trace].robotType;
    EXPECT_EQ(window.leftOut, type == 1 || type == 3);
    // The crouch begins with a small drop and then rests until row 50.
    if (evidence.traces()[window.trace].name.starts_with("crouch")) {
      EXPECT_TRUE(window.first < 10 || window.first > 44) << window.first;
    }
  }
}

TEST(TraceEvidence, NeedsRecordingsForBoth) {
  auto one = leagueTraces();
  one.resize(1);
  EXPECT_EQ(
      thrownBy([&] { TraceEvidence evidence(one); }),
      "too few recordings in which the robot moves: some are for fitting and some of another robot type for "
      "judging; give at least two");
  EXPECT_EQ(thrownBy([] { readTraces("no/such/folder"); }),
            "no/such/folder: no folder of recordings can be read here");
  const auto empty = std::filesystem::temp_directory_path() / "plumbline-no-traces";
  std::filesystem::create_directories(empty);
  EXPECT_EQ(thrownBy([&] { readTraces(empty); }),
            empty.string() + ": no recordings of a robot, *_t0.csv.gz to *_t4.csv.gz, are in this folder");
}

}  // namespace
}  // namespace plumbline::gap
