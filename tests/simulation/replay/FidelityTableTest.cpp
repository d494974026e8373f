#include "simulation/replay/FidelityTable.h"

#include <gtest/gtest.h>

#include "support/RecordedFidelity.h"

namespace plumbline::simulation {
namespace {

/// One recording of each kind, robot types in turn; all of them are in tests/fidelity.
const std::vector<std::string> oneOfEach = {
    "ball_bounce_1m", "ball_lob_v6", "ball_roll_v3", "ballfoot_v3_off0_t3", "crouch_t1",  "fallB_t4",
    "fallF_t3",       "stand_t0",    "swing_t0",     "ut_getup_t3",         "ut_kick_t3", "ut_turn_t0",
    "ut_walk_t2"};

TEST(FidelityTable, theLeaguesEngineMeetsTheTargetsOfEachKindOfRecording) {
  int asked = 0;
  for (const FidelityLine& line : test::fidelityOf(oneOfEach, "ode")) {
    EXPECT_TRUE(line.met()) << test::text(line);
    asked += line.allowed().has_value();
  }
  EXPECT_GE(asked, 26);
}

TEST(FidelityTable, bulletPlaysEachKindOfRecording) {
  int met = 0;
  for (const FidelityLine& line : test::fidelityOf(oneOfEach, "bullet")) met += line.allowed() && line.met();
  EXPECT_GE(met, 10);
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

FidelityLine lineOf(const std::vector<FidelityLine>& lines, const std::string& figure) {
  for (const FidelityLine& line : lines)
    if (line.figure == figure) return line;
  ADD_FAILURE() << "no figure " << figure;
  return {};
}

TEST(FidelityTable, heightsOfABallAreThoseBetweenItsBounces) {
  simspark::LeagueTrace trace;
  trace.name = "ball_bounce";
  for (const double z :
       {1.0, 0.8, 0.4, 0.042, 0.3, 0.5, 0.45, 0.2, 0.042, 0.2, 0.25, 0.1, 0.042, 0.05, 0.042})
    trace.rows.emplace_back().ball = {0, 0, z};
  std::vector<simspark::TraceRow> ours = trace.rows;
  ours[5].ball.z() = 0.49;
  const std::vector<FidelityLine> lines = fidelityLines(trace, ours, {});
  const FidelityLine first = lineOf(lines, "ball, height 1"), second = lineOf(lines, "ball, height 2");
  EXPECT_EQ(first.league, 0.5);
  EXPECT_EQ(first.ours, 0.49);
  EXPECT_EQ(second.league, 0.25);
  for (const FidelityLine& line : lines) EXPECT_NE(line.figure, "ball, height 3") << "it rolls";
}

TEST(FidelityTable, deviationsOfTheTorsoAreInMillimetres) {
  simspark::LeagueTrace trace;
  trace.rows.resize(200);
  std::vector<simspark::TraceRow> ours = trace.rows;
  ours[100].torso.translation().x() = 0.002;
  for (const char* name : {"swing_t0", "stand_t0"}) {
    trace.name = name;
    EXPECT_NEAR(lineOf(fidelityLines(trace, ours, {}), "torso, largest deviation").difference, 2, 1e-9)
        << name;
  }
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
