#include "simulation/replay/FidelityTable.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "simspark/LeagueRobots.h"
#include "simulation/replay/Replay.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {
namespace {

/// All lines of all recordings on an engine.
std::vector<FidelityLine> table(const std::string& engine) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator("tests/data/traces"))
    if (entry.path().string().ends_with(".csv.gz")) files.push_back(entry.path());
  EXPECT_EQ(files.size(), 53u);
  std::sort(files.begin(), files.end());
  WorldConfig config;
  config.engine = engine;
  std::vector<FidelityLine> all;
  for (const auto& file : files) {
    const simspark::LeagueTrace trace = simspark::readLeagueTrace(file);
    const auto lines =
        fidelityLines(trace, replay(trace, simsparkRobot(trace.robotType.value_or(0)), config), {});
    EXPECT_FALSE(lines.empty()) << trace.name;
    all.insert(all.end(), lines.begin(), lines.end());
  }
  return all;
}

/// A line as text, for those that fail.
std::string text(const FidelityLine& line) {
  return line.trace + ", " + line.figure + ": off by " + std::to_string(line.difference) + " " + line.unit;
}

TEST(FidelityTable, theLeaguesEngineMeetsEveryTarget) {
  int asked = 0;
  for (const FidelityLine& line : table("ode")) {
    EXPECT_TRUE(line.met()) << text(line);
    asked += line.allowed().has_value();
  }
  EXPECT_GE(asked, 118);
}

/// Bullet is not the league's physics; what it does reach is held.
TEST(FidelityTable, bulletKeepsItsLevel) {
  int met = 0;
  for (const FidelityLine& line : table("bullet")) {
    met += line.allowed() && line.met();
    const bool still = line.trace.starts_with("stand") || line.trace.starts_with("crouch") ||
                       line.trace.starts_with("ball_") || line.trace.starts_with("fallF");
    if (still && line.unit != "s") {
      EXPECT_TRUE(line.met()) << text(line);
    }
    if (line.trace.starts_with("fall") && line.unit == "s") {
      EXPECT_LE(std::abs(line.difference), 0.0801);
    }
    if (line.trace.starts_with("ut_getup") && line.figure == "torso up-axis z, last") {
      EXPECT_TRUE(line.met()) << text(line);
    }
    if (line.trace.starts_with("ballfoot") && line.unit == "m/s") {
      EXPECT_LE(std::abs(line.difference), 0.07) << text(line);
    }
  }
  EXPECT_GE(met, 52) << "58 where it was measured; walks that fall differ between processors";
}

FidelityLine line(FidelityTarget target, double difference, std::optional<double> league) {
  FidelityLine line;
  line.target = target;
  line.difference = difference;
  line.league = league;
  return line;
}

TEST(FidelityTable, targetsAreAbsoluteOrRelative) {
  EXPECT_TRUE(line({2.0, {}}, -2, {}).met());
  EXPECT_FALSE(line({2.0, {}}, -2.1, {}).met());
  EXPECT_TRUE(line({{}, 0.05}, 0.2, -4).met());
  EXPECT_FALSE(line({{}, 0.05}, 0.21, -4).met());
  EXPECT_TRUE(line({}, 1e9, 1).met());
  EXPECT_EQ(line({}, 1e9, 1).allowed(), std::nullopt);
}

TEST(FidelityTable, theServersOwnSpreadLiftsTargetsOfGaitsAlone) {
  const auto walk = simspark::readLeagueTrace("tests/data/traces/ut_walk_t3.csv.gz");
  const auto again = simspark::readLeagueTrace("tests/data/traces/ut_walk_replay_t3.csv.gz");
  const LeagueSpread spread = leagueSpread(walk, again);
  EXPECT_NEAR(spread.at("speed, last 5 s"), 0.075, 0.001);
  EXPECT_NEAR(spread.at("torso, at the end"), 499, 1);
  for (const FidelityLine& l : fidelityLines(walk, walk.rows, spread)) {
    EXPECT_EQ(l.difference, 0) << l.figure;
    EXPECT_EQ(l.spread, spread.at(l.figure));
    if (l.figure == "speed, last 5 s") {
      EXPECT_FALSE(l.allowed()) << "the server is 10 % off itself";
    }
    if (l.figure == "torso, first 2 s") {
      EXPECT_EQ(l.allowed(), 2.0);
    }
  }
}

}  // namespace
}  // namespace plumbline::simulation
