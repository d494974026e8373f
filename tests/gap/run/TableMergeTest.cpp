#include "gap/run/TableMerge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

using Numbers = std::vector<double>;
constexpr double lost = -99;  ///< stands for NaN in what is compared

Numbers shown(Numbers values) {
  for (double& x : values)
    if (std::isnan(x)) x = lost;
  return values;
}

Numbers times(double begin, double step, std::size_t count) {
  Numbers t;
  for (std::size_t i = 0; i < count; ++i) t.push_back(begin + step * static_cast<double>(i));
  return t;
}

/// Readings at 0, 1, 2, 3, 4 s.
TimedChannels readings() { return {"readings.csv", times(0, 1, 5), {{"pos.Knee", {0, 1, 2, 3, 4}}}, {}}; }
TimedChannels commands(Numbers t, Numbers values) {
  return {"commands.csv", std::move(t), {{"cmd.Knee", std::move(values)}}, {}};
}

TEST(TableMerge, aRowHasTheCommandInForce) {
  const MergedChannels merged = mergeChannels({commands({0.5, 1, 2.9, 3.1}, {10, 11, 12, 13}), readings()});
  EXPECT_EQ(merged.rowsFrom, 1U);
  EXPECT_EQ(merged.t, (Numbers{0, 1, 2, 3, 4}));
  EXPECT_EQ(shown(merged.channels.at("cmd.Knee")), (Numbers{lost, 11, 11, 12, 13}));
  EXPECT_EQ(merged.channels.at("pos.Knee"), (Numbers{0, 1, 2, 3, 4}));
  // New at 1, 3 and 4 s: sent 0, 0.1 and 0.9 s before.
  EXPECT_NEAR(merged.timing.at("Knee").cmdAt, -0.1, 1e-12);
  EXPECT_EQ(merged.notes,
            std::vector<std::string>{
                "commands.csv: 4 lines of commands onto 5 rows; replaced before the next row: 1 (hold: "
                "linear interpolates); rows before the first: 1, without a command; sent 100 ms before their "
                "row (cmd_at_s in timing), +-800 ms"});
}

TEST(TableMerge, anEmptyCellOfACommandChangesNothing) {
  const MergedChannels merged = mergeChannels({commands({0, 1, 2}, {10, NAN, 12}), readings()});
  EXPECT_EQ(merged.channels.at("cmd.Knee"), (Numbers{10, 10, 12, 12, 12}));
  EXPECT_TRUE(merged.timing.empty()) << "they have the same clock";
}

TEST(TableMerge, linearCommandsAreInterpolatedBetweenTwoOnly) {
  const MergedChannels merged =
      mergeChannels({commands({0.5, 1.5, 3}, {10, 20, 50}), readings()}, {.linearCommands = true});
  const Numbers expected = {lost, 15, 30, 50, lost};
  const Numbers values = shown(merged.channels.at("cmd.Knee"));
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-9) << i;
  EXPECT_TRUE(merged.timing.empty());
}

TEST(TableMerge, stiffnessIsNeverInterpolated) {
  TimedChannels switches = commands({0, 2.5}, {0, 10});
  switches.channels["stiffness.Knee"] = {0, 1};
  const MergedChannels merged = mergeChannels({switches, readings()}, {.linearCommands = true});
  EXPECT_EQ(merged.channels.at("stiffness.Knee"), (Numbers{0, 0, 0, 1, 1}));
}

TEST(TableMerge, readingsOfASlowerDeviceLeaveRowsEmpty) {
  const TimedChannels imu{"imu.csv", {0.1, 2.0, 3.9, 9}, {{"gyro.x", {5, 6, 7, 8}}}, {}};
  const MergedChannels merged = mergeChannels({readings(), imu});
  EXPECT_EQ(merged.rowsFrom, 0U);
  EXPECT_EQ(shown(merged.channels.at("gyro.x")), (Numbers{5, lost, 6, lost, 7}));
  EXPECT_EQ(merged.notes, std::vector<std::string>{
                              "imu.csv: 3 of 4 readings stand in a row; rows without one: 2; taken up to "
                              "100 ms from their row"});
}

TEST(TableMerge, oneReadingNeverStandsInTwoRows) {
  const TimedChannels fast{"fast.csv", times(0, 0.25, 17), {{"gyro.x", times(0, 1, 17)}}, {}};
  const TimedChannels slow{"slow.csv", {1.5, 3}, {{"gyro.y", {1, 2}}}, {}};
  const MergedChannels merged = mergeChannels({readings(), fast, slow});
  EXPECT_EQ(merged.channels.at("gyro.x"), (Numbers{0, 4, 8, 12, 16}));
  EXPECT_EQ(shown(merged.channels.at("gyro.y")), (Numbers{lost, 1, lost, 2, lost}));
}

TEST(TableMerge, aConstantDistanceOfTheTimesGoesIntoTheTiming) {
  // Just over half a row later: partners must not flip from row to row.
  Numbers t = times(0.52, 1, 5);
  for (std::size_t i = 0; i < t.size(); ++i) t[i] += i % 2 ? 0.03 : -0.03;
  const TimedChannels other{"arm.csv", t, {{"pos.Arm", {0, 1, 2, 3, 4}}, {"vel.Arm", {0, 1, 2, 3, 4}}}, {}};
  const MergedChannels merged = mergeChannels({readings(), other});
  const double shift = merged.timing.at("Arm").posAt;
  EXPECT_NEAR(std::abs(shift), 0.5, 0.06);
  EXPECT_EQ(merged.timing.at("Arm").velAt, shift);
  EXPECT_EQ(merged.timing.at("Knee").posAt, 0);
  std::size_t found = 0;
  for (const double x : merged.channels.at("pos.Arm")) found += !std::isnan(x);
  EXPECT_GE(found, 4U);
}

TEST(TableMerge, aStatedTimingIsKeptAndAToleranceRespected) {
  TimedChannels other{"arm.csv", times(0.2, 1, 5), {{"pos.Arm", {0, 1, 2, 3, 4}}}, {}};
  const MergedChannels merged = mergeChannels({readings(), other}, {.timingStated = true});
  EXPECT_TRUE(merged.timing.empty());
  EXPECT_EQ(merged.channels.at("pos.Arm"), (Numbers{0, 1, 2, 3, 4}));
  other.within = 0.1;
  EXPECT_EQ(
      thrownBy([&] {
        mergeChannels({readings(), other}, {.timingStated = true});
      }),
      "arm.csv: no reading is within 100 ms of a row of readings.csv; correct offset or within under time "
      "in the map");
}

TEST(TableMerge, theFastestPositionsMakeTheRows) {
  const TimedChannels fast{"fast.csv", times(0, 0.5, 9), {{"pos.Arm", times(0, 1, 9)}}, {}};
  const TimedChannels imu{"imu.csv", times(0, 0.1, 41), {{"gyro.x", times(0, 1, 41)}}, {}};
  const MergedChannels merged = mergeChannels({readings(), fast, imu});
  EXPECT_EQ(merged.rowsFrom, 1U);
  EXPECT_EQ(shown(merged.channels.at("pos.Knee")), (Numbers{0, lost, 1, lost, 2, lost, 3, lost, 4}));
}

TEST(TableMerge, timesThatDoNotOverlapAreRefused) {
  EXPECT_EQ(thrownBy([] {
              mergeChannels({commands({100, 101}, {1, 2}), readings()});
            }),
            "commands.csv: its times, 100.000 to 101.000 s, do not overlap those of readings.csv, 0.000 to "
            "4.000 s; correct unit or offset under time in the map (with an offset of -100.000 s both begin "
            "together)");
}

}  // namespace
}  // namespace plumbline::gap
