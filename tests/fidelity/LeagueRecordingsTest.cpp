// All recordings of the league's server; one of each kind is in
// tests/simulation/replay/FidelityTableTest.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "simulation/replay/FidelityTable.h"
#include "support/RecordedFidelity.h"

namespace plumbline::simulation {
namespace {

std::vector<FidelityLine> table(const std::string& engine) {
  constexpr std::string_view ending = ".csv.gz";
  std::vector<std::string> recordings;
  for (const auto& entry : std::filesystem::directory_iterator("tests/data/traces"))
    if (const std::string file = entry.path().filename(); file.ends_with(ending))
      recordings.push_back(file.substr(0, file.size() - ending.size()));
  EXPECT_EQ(recordings.size(), 53u);
  std::ranges::sort(recordings);
  return test::fidelityOf(recordings, engine);
}

TEST(LeagueRecordings, theLeaguesEngineMeetsEveryTarget) {
  int asked = 0;
  for (const FidelityLine& line : table("ode")) {
    EXPECT_TRUE(line.met()) << test::text(line);
    asked += line.allowed().has_value();
  }
  EXPECT_GE(asked, 118);
}

/// Bullet is not the league's physics; what it does reach is held.
TEST(LeagueRecordings, bulletKeepsItsLevel) {
  int met = 0;
  for (const FidelityLine& line : table("bullet")) {
    met += line.allowed() && line.met();
    const bool still = line.trace.starts_with("stand") || line.trace.starts_with("crouch") ||
                       line.trace.starts_with("ball_") || line.trace.starts_with("fallF");
    if (still && line.unit != "s") {
      EXPECT_TRUE(line.met()) << test::text(line);
    }
    if (line.trace.starts_with("fall") && line.unit == "s") {
      EXPECT_LE(std::abs(line.difference), 0.0801);
    }
    if (line.trace.starts_with("ut_getup") && line.figure == "torso up-axis z, last") {
      EXPECT_TRUE(line.met()) << test::text(line);
    }
    if (line.trace.starts_with("ballfoot") && line.unit == "m/s") {
      EXPECT_LE(std::abs(line.difference), 0.07) << test::text(line);
    }
  }
  EXPECT_GE(met, 52) << "58 where it was measured; walks that fall differ between processors";
}

}  // namespace
}  // namespace plumbline::simulation
