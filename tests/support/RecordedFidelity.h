#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "simspark/LeagueRobots.h"
#include "simulation/replay/FidelityTable.h"
#include "simulation/replay/TraceReplay.h"
#include "simulation/world/World.h"

namespace plumbline::simulation::test {

/// All lines of these recordings of tests/data/traces on an engine; each recording has to give some.
inline std::vector<FidelityLine> fidelityOf(const std::vector<std::string>& recordings,
                                            const std::string& engine) {
  WorldConfig config;
  config.engine = engine;
  std::vector<FidelityLine> all;
  for (const std::string& recording : recordings) {
    const simspark::LeagueTrace trace =
        simspark::readLeagueTrace("tests/data/traces/" + recording + ".csv.gz");
    const auto lines =
        fidelityLines(trace, replayTrace(trace, simsparkRobot(trace.robotType.value_or(0)), config), {});
    EXPECT_FALSE(lines.empty()) << trace.name;
    all.insert(all.end(), lines.begin(), lines.end());
  }
  return all;
}

/// A line as text, for those that fail.
inline std::string text(const FidelityLine& line) {
  return line.trace + ", " + line.figure + ": off by " + std::to_string(line.difference) + " " + line.unit;
}

}  // namespace plumbline::simulation::test
