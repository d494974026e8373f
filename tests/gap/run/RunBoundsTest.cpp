#include <gtest/gtest.h>

#include <cmath>

#include "PendulumRun.h"
#include "gap/run/ColumnStatistics.h"

namespace plumbline::gap {
namespace {

Run swinging() {
  return pendulumRun([](double t) { return 0.4 * std::sin(2 * t); },
                     [](double t) { return 0.4 * std::sin(2 * t - 0.1); });
}

struct Range {
  std::string column;
  double low, high;
};

/// What no sensor gives, of each quantity; a hundredth beyond is reported with the range.
TEST(RunBounds, valuesThatNoSensorGivesAreLeftOutWithTheRange) {
  for (const Range& range :
       {Range{"stiffness.pendulum", 0, 1}, Range{"vel.pendulum", -60, 60},
        Range{"torque.pendulum", -500, 500}, Range{"current.pendulum", -200, 200},
        Range{"voltage.pendulum", -100, 100}, Range{"duty.pendulum", -1.001, 1.001},
        Range{"temperature.pendulum", -30, 150}, Range{"gyro.x", -60, 60}, Range{"acc.z", -400, 400},
        Range{"cmd_vel.pendulum", -60, 60}, Range{"cmd_torque.pendulum", -500, 500}}) {
    const double beyond = 0.01 * (range.high - range.low);
    for (const double value : {range.low - beyond, range.low, range.high, range.high + beyond}) {
      gap::Run run = swinging();
      run.channels[range.column].assign(run.size(), 0.5);
      run.channels[range.column][5] = value;
      const std::string line = "r: " + range.column + " is left out: it reaches " + shownNumber(value) +
                               ", outside " + shownNumber(range.low) + " to " + shownNumber(range.high) +
                               "; check its unit\n";
      const bool outside = value < range.low || value > range.high;
      EXPECT_EQ(saidOf(run).find(line) != std::string::npos, outside) << line << saidOf(run);
      EXPECT_EQ(saidOf(run).find("outside") != std::string::npos, outside) << saidOf(run);
    }
  }
}

TEST(RunBounds, aSoleCarriesNoTonAndPullsNothing) {
  for (const double value : {-11.0, -9.0, 990.0, 1010.0}) {
    gap::Run run = swinging();
    run.robot = "nao_v5";
    for (const char* kind : {"cmd.", "pos."}) {
      run.channels[std::string(kind) + "HeadYaw"] = run.channels[std::string(kind) + "pendulum"];
      run.channels.erase(std::string(kind) + "pendulum");
    }
    run.channels["fsr.LFoot.FrontLeft"].assign(run.size(), 5.0);
    run.channels["fsr.LFoot.FrontLeft"][5] = value;
    const std::string said = saidOf(run, "nao_v5");
    const std::string line = "r: fsr.LFoot.FrontLeft is left out: it reaches " + shownNumber(value) +
                             ", outside -10 to 1000; check its unit\n";
    EXPECT_EQ(said.find(line) != std::string::npos, value < -10 || value > 1000) << said;
  }
}

TEST(RunBounds, aRateThatIsFarFromTheTimesIsRefused) {
  gap::Run run = swinging();
  for (const double rate : {85.0, 120.0}) {
    run.rateHz = rate;
    EXPECT_EQ(saidOf(run).find("refused"), std::string::npos) << saidOf(run);
  }
  run.rateHz = 75;
  EXPECT_EQ(saidOf(run),
            "refused: r: t advances 0.01 s a line, but rate_hz 75 says 0.01333 s; correct one of them");
  run.rateHz = 130;
  EXPECT_EQ(saidOf(run),
            "refused: r: t advances 0.01 s a line, but rate_hz 130 says 0.007692 s; correct one of them");
}

TEST(RunBounds, onlyAThousandfoldIsTakenForMilliseconds) {
  gap::Run run = swinging();
  for (const double factor : {1100.0, 1320.0}) {
    gap::Run scaled = run;
    for (double& t : scaled.t) t *= factor;
    EXPECT_EQ(saidOf(scaled).ends_with("; is t in ms?"), factor == 1100) << saidOf(scaled);
    EXPECT_EQ(saidOf(scaled).ends_with("; correct one of them"), factor != 1100) << saidOf(scaled);
  }
}

/// Without each n-th line.
Run without(const Run& run, std::size_t n) {
  gap::Run less = run;
  less.t.clear();
  for (auto& [name, column] : less.channels) column.clear();
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (i % n == n - 1) continue;
    less.t.push_back(run.t[i]);
    for (auto& [name, column] : less.channels) column.push_back(run.channels.at(name)[i]);
  }
  return less;
}

TEST(RunBounds, gapsAreReportedWhereTheyAreAFifthOfTheTime) {
  EXPECT_EQ(saidOf(without(swinging(), 12)), "");
  const std::string said = saidOf(without(swinging(), 8));
  EXPECT_TRUE(said.starts_with("r: t: 25") || said.starts_with("r: t: 24.")) << said;
  EXPECT_TRUE(said.ends_with(" % of the time is in gaps\n")) << said;
}

TEST(RunBounds, linesThatComeHalfACycleLateAreNoGaps) {
  gap::Run run = swinging();
  for (std::size_t i = 3; i < run.size(); i += 4) run.t[i] += 0.005;
  EXPECT_EQ(saidOf(run), "");
}

TEST(RunBounds, lostSamplesAreReportedWhereTheyAreMoreThanHalf) {
  for (const std::size_t lost : {4U, 6U}) {
    gap::Run run = swinging();
    std::vector<double>& column = run.channels["temperature.pendulum"];
    for (std::size_t i = 0; i < run.size(); ++i) column.push_back(i % 10 < lost ? std::nan("") : 30);
    EXPECT_EQ(saidOf(run), lost < 5 ? "" : "r: temperature.pendulum: 60 % of the samples are lost\n");
  }
}

TEST(RunBounds, aShortRunIsReported) {
  gap::Run run = pendulumRun([](double t) { return 0.4 * std::sin(6 * t); },
                             [](double t) { return 0.4 * std::sin(6 * t - 0.1); }, 100, 0.9);
  EXPECT_EQ(saidOf(run), "r: t: the run is only 0.89 s long; little can be learnt from it\n");
}

}  // namespace
}  // namespace plumbline::gap
