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

// Recordings have millionths of a metre, hundredths of a degree and of m/s^2 and N.
TEST(TraceEvidence, noErrorIsSmallerThanHalfTheLastDigit) {
  const WindowError least = typicalError(std::vector<WindowError>(10));
  const WindowError expected = {5e-7, 5e-7, 8.7266e-5, 8.7266e-5, 0.005, 0.005};
  for (std::size_t s = 0; s < least.size(); ++s)
    EXPECT_NEAR(least[s], expected[s], 1e-4 * expected[s]) << nameOf(static_cast<TraceSignal>(s));
}

TEST(TraceEvidence, aWindowIsIdleWhereNothingMovesHalfAMillimetreOrASixthOfADegree) {
  // Windows of five rows, in which the torso goes so far and the head turns so far.
  const auto isIdle = [](double way, double turn) {
    std::vector<simspark::LeagueTrace> traces(2);
    for (int type : {0, 1}) {
      traces[static_cast<std::size_t>(type)].robotType = type;
      traces[static_cast<std::size_t>(type)].joints = {headYaw};
      for (int i = 0; i < 200; ++i) {
        simspark::TraceRow& row = traces[static_cast<std::size_t>(type)].rows.emplace_back();
        row.torso.translation().x() = way * i / 5;
        row.angle[headYaw] = turn * i / 5;
      }
    }
    return thrownBy([&] { TraceEvidence evidence(traces, 5, 5); }) != "nothing thrown";
  };
  EXPECT_TRUE(isIdle(0, 0));
  EXPECT_TRUE(isIdle(0.00045, 0));
  EXPECT_FALSE(isIdle(0.00055, 0));
  EXPECT_TRUE(isIdle(0, 0.0027));
  EXPECT_FALSE(isIdle(0, 0.0033));
}

}  // namespace
}  // namespace plumbline::gap
