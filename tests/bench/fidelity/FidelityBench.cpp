// Replays every recording of the league's server on both engines: one table with the league's value, ours,
// the difference, the server's own spread and the target. Prints it, writes it to build/bench/fidelity.md and
// a summary to build/bench/fidelity.json. One argument: the folder of recordings (tests/data/traces).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "simspark/LeagueRobots.h"
#include "simulation/replay/Fidelity.h"
#include "simulation/replay/FidelityTable.h"
#include "simulation/replay/TraceReplay.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {
namespace {

using nlohmann::json;

std::vector<std::filesystem::path> recordings(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().string().ends_with(".csv.gz")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) throw std::runtime_error(folder.string() + ": no recordings *.csv.gz");
  return files;
}

/// The same commands on the league's server once more: a walk and its replay are each other's, of others
/// there may be a recording in the folder "again".
LeagueSpread spreadOf(const simspark::LeagueTrace& trace, const std::filesystem::path& folder) {
  std::filesystem::path other = folder / "again" / (trace.name + ".csv.gz");
  const std::string walk = "ut_walk_", replayed = "ut_walk_replay_";
  if (trace.name.starts_with(replayed))
    other = folder / (walk + trace.name.substr(replayed.size()) + ".csv.gz");
  else if (trace.name.starts_with(walk))
    other = folder / (replayed + trace.name.substr(walk.size()) + ".csv.gz");
  if (!std::filesystem::exists(other)) return {};
  return leagueSpread(trace, simspark::readLeagueTrace(other));
}

std::string number(std::optional<double> value) {
  if (!value) return "";
  if (std::isnan(*value)) return "never";
  char text[32];
  std::snprintf(text, sizeof text, std::abs(*value) >= 1000 ? "%.1f" : "%.4g", *value);
  return text;
}

std::string difference(const FidelityLine& line) {
  return number(line.difference) + (!line.allowed() ? "" : line.met() ? "" : " !");
}

/// How a group of traces does: lines with a target, and those that meet it.
struct Tally {
  int asked = 0, met = 0;
  void add(const FidelityLine& line) {
    if (!line.allowed()) return;
    ++asked;
    met += line.met();
  }
};

std::string groupOf(const std::string& trace) {
  std::string name = trace.substr(0, trace.find_last_of('_'));
  for (const char* group : {"ballfoot", "ball_", "fall", "ut_walk"})
    if (name.starts_with(group)) name = group;
  if (name.starts_with("ut_")) name = name.substr(3);
  return name == "ball_" ? "ball_alone" : name;
}

void run(const std::filesystem::path& folder) {
  std::ofstream page("build/bench/fidelity.md");
  page << "| recording | figure | unit | league | ODE | Bullet | ODE off by | Bullet off by | "
          "league off itself by | target |\n|---|---|---|---|---|---|---|---|---|---|\n";
  std::printf("%-20s %-28s %-5s %10s %10s %10s %10s %12s %10s %9s\n", "recording", "figure", "unit", "league",
              "ODE", "Bullet", "ODE off", "Bullet off", "own spread", "target");
  std::map<std::string, Tally> ode, bullet;
  Tally odeAll, bulletAll;
  int traces = 0;
  for (const auto& file : recordings(folder)) {
    const simspark::LeagueTrace trace = simspark::readLeagueTrace(file);
    const RobotModel model = simsparkRobot(trace.robotType.value_or(0));
    const LeagueSpread spread = spreadOf(trace, folder);
    const auto lines = [&](const char* engine) {
      WorldConfig config;
      config.engine = engine;
      return fidelityLines(trace, replayTrace(trace, model, config), spread);
    };
    const std::vector<FidelityLine> onOde = lines("ode"), onBullet = lines("bullet");
    ++traces;
    for (std::size_t i = 0; i < onOde.size(); ++i) {
      const FidelityLine &o = onOde[i], &b = onBullet[i];
      ode[groupOf(o.trace)].add(o);
      bullet[groupOf(o.trace)].add(b);
      odeAll.add(o);
      bulletAll.add(b);
      page << "| " << o.trace << " | " << o.figure << " | " << o.unit << " | " << number(o.league) << " | "
           << number(o.ours) << " | " << number(b.ours) << " | " << difference(o) << " | " << difference(b)
           << " | " << number(o.spread) << " | " << number(o.allowed()) << " |\n";
      std::printf("%-20s %-28s %-5s %10s %10s %10s %10s %12s %10s %9s\n", o.trace.c_str(), o.figure.c_str(),
                  o.unit.c_str(), number(o.league).c_str(), number(o.ours).c_str(), number(b.ours).c_str(),
                  difference(o).c_str(), difference(b).c_str(), number(o.spread).c_str(),
                  number(o.allowed()).c_str());
    }
  }
  std::printf("\n%d recordings; \"!\" misses its target. Targets met: ODE %d of %d, Bullet %d of %d\n",
              traces, odeAll.met, odeAll.asked, bulletAll.met, bulletAll.asked);
  json figures = json::array();
  const auto add = [&](const std::string& name, const Tally& tally, bool asked) {
    json figure = {
        {"name", "fidelity." + name}, {"value", tally.met}, {"unit", "lines"}, {"better", "higher"}};
    if (asked)
      figure["target"] = tally.asked;
    else
      figure["unit"] = "of " + std::to_string(tally.asked);
    figures.push_back(figure);
  };
  for (const auto& [group, tally] : ode) add("ode." + group, tally, true);
  for (const auto& [group, tally] : bullet) add("bullet." + group, tally, false);
  std::ofstream("build/bench/fidelity.json") << figures.dump(1) << '\n';
}

}  // namespace
}  // namespace plumbline::simulation

int main(int argc, char** argv) {
  try {
    std::filesystem::create_directories("build/bench");
    plumbline::simulation::run(argc > 1 ? argv[1] : "tests/data/traces");
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "FidelityBench: %s\n", problem.what());
    return 1;
  }
}
