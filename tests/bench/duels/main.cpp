// How often three robots score that have the ball before the goal of three others, which all go to the ball
// (config/platforms/simspark/swarm.cfg). Writes build/bench/duels.json and .md. Environment:
//   TRIES   duels of each team [200]
//   SEED    of the first one's places [1]
//   JOBS    simulators at once [one per core]
//   BEFORE  folder of an earlier state that is built: its players attack the same defenders, too
//   OTHERS  modules.cfg of the defenders [config/platforms/simspark/swarm.cfg]
// With --set-pieces it measures set pieces instead (SetPieceTable.cpp), for
// tests/bench/set-pieces/set-pieces.sh.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "Duel.h"
#include "PlayAll.h"
#include "SetPiece.h"
#include "framework/WriteFile.h"
#include "gap/blind/BlindScore.h"
#include "support/Environment.h"
#include "support/FigureJson.h"

namespace plumbline::bench {
namespace {

using nlohmann::json;

const char* const folder = "build/bench";

/// A column of the table and the figures of a team.
class Column {
public:
  Column(const std::string& name, const std::vector<DuelResult>& results, json& figures) : name_(name) {
    for (std::size_t end = 0; end < duelEndNames.size(); ++end)
      share(duelEndNames[end], results,
            [&](const DuelResult& result) { return result.end == static_cast<DuelEnd>(end); });
    const auto count = static_cast<double>(results.size());
    const auto mean = [&](auto DuelResult::*what) {
      double sum = 0;
      for (const DuelResult& result : results) sum += result.*what;
      return sum / count;
    };
    const double nearest = 100 * mean(&DuelResult::nearest), falls = mean(&DuelResult::falls);
    const auto row = [&](const char* what, const char* format, double value) {
      rows_.emplace_back(what, fmt::format(fmt::runtime(format), value));
    };
    row("an attacker nearest to the ball [% of the time]", "{:.0f}", nearest);
    row("falls of attackers a duel", "{:.2f}", falls);
    row("fouls of attackers a duel: charging", "{:.2f}", mean(&DuelResult::charging));
    row("touching", "{:.2f}", mean(&DuelResult::touching));
    const auto goals = std::ranges::count(results, DuelEnd::goal, &DuelResult::end);
    figures.push_back(figureJson(fmt::format("duels.{}.goals", name),
                                 100.0 * static_cast<double>(goals) / count, "%", "higher"));
    figures.push_back(figureJson(fmt::format("duels.{}.nearest", name), nearest, "%", "higher"));
    figures.push_back(figureJson(fmt::format("duels.{}.falls", name), falls, "1", "lower"));
  }

  const std::string& name() const { return name_; }
  const std::vector<std::pair<std::string, std::string>>& rows() const { return rows_; }

private:
  template <class Test>
  void share(const char* what, const std::vector<DuelResult>& results, Test test) {
    const auto yes = static_cast<std::size_t>(std::ranges::count_if(results, test));
    const gap::Figure of = gap::share("", "", yes, results.size());
    rows_.emplace_back(fmt::format("{} [%]", what), fmt::format("{:.1f} ({:.0f} to {:.0f})", 100 * of.value,
                                                                100 * of.lower, 100 * of.upper));
  }

  std::string name_;
  std::vector<std::pair<std::string, std::string>> rows_;
};

const char* const head =
    "{} duels of three against three, at most {:.0f} s each, places by lot with seeds from {}. The ball lies "
    "1 "
    "to 6 m before the goal, a robot of each team stands at it, and two more of each are near. The defenders "
    "all go to the ball. Shares have 95 % intervals (Wilson). The places come from the seed. A trainer's "
    "messages reach the simulator at any cycle, so the same seeds do not repeat a duel.\n\n|";

std::string table(const std::vector<Column>& columns, int tries, std::uint64_t seed) {
  std::string text = fmt::format(fmt::runtime(head), tries, Duel::longest, seed);
  for (const Column& column : columns) text += " | " + column.name();
  text += " |\n|---|";
  for (std::size_t i = 0; i < columns.size(); ++i) text += "---|";
  for (std::size_t row = 0; row < columns.front().rows().size(); ++row) {
    text += "\n| " + columns.front().rows()[row].first + " |";
    for (const Column& column : columns) text += " " + column.rows()[row].second + " |";
  }
  return text + "\n\n";
}

void run() {
  const auto tries = static_cast<int>(environment("TRIES", 200));
  const auto jobs = static_cast<int>(environment("JOBS", std::max(1U, std::thread::hardware_concurrency())));
  const std::uint64_t seed = environment("SEED", 1);
  if (tries < 1 || jobs < 1 || jobs > 64) throw std::runtime_error("TRIES is 1 or more, JOBS is 1 to 64");
  const std::string defence = environmentText("OTHERS", "config/platforms/simspark/swarm.cfg");
  const std::string before = environmentText("BEFORE", "");
  if (!before.empty() && !std::filesystem::exists(before + "/bin/agent"))
    throw std::runtime_error("BEFORE=" + before + " has no bin/agent: build it there");
  json figures = json::array();
  std::vector<Column> columns;
  const auto add = [&](const std::string& name, const std::string& root) {
    const DuelOptions options{"bin", root + "/bin", defence, fmt::format("{}/duels", folder)};
    columns.emplace_back(
        name,
        playAll<Duel>(name, "duels", options, tries, jobs, seed,
                      [&](Duel& duel, int i) { return duel.play(seed + static_cast<std::uint64_t>(i)); }),
        figures);
  };
  std::filesystem::remove_all(fmt::format("{}/duels", folder));
  add("now", ".");
  if (!before.empty()) add("before", before);
  const std::string text = table(columns, tries, seed);
  writeFile(fmt::format("{}/duels.json", folder), figures.dump(1) + "\n");
  writeFile(fmt::format("{}/duels.md", folder), text);
  fmt::print("{}", text);
}

}  // namespace
}  // namespace plumbline::bench

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::string_view(argv[1]) == "--set-pieces")
      plumbline::bench::measureSetPieces();
    else
      plumbline::bench::run();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "duels: %s\n", error.what());
    return 2;
  }
}
