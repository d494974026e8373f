// What draws are worth to a kick: the same search, from the same start,
// with the same seeds and as many runs, once in the nominal world alone and once over drawn robots. Then both
// kicks are tried in the nominal world, on Bullet, whose physics neither has seen, and on drawn robots that
// were in no search. Environment: TYPE [0], MOTION [kickRight], SEEDS [3], GENERATIONS [80], MEASURED [200]
// tries of each. Writes build/bench/robust.json and .md.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "framework/WriteFile.h"
#include "optimization/Optimizers.h"
#include "optimization/Search.h"
#include "support/Environment.h"
#include "support/FigureJson.h"
#include "training/SearchTask.h"

using namespace plumbline;
using namespace plumbline::bench;
using namespace plumbline::training;
using Options = std::map<std::string, std::string>;

namespace {

constexpr int population = 12, runsOfEach = 4;
constexpr const char* effects = "config/optimisation/unlike.yaml";
constexpr const char* drawsOfSearch = "8";
constexpr std::uint64_t firstMeasured = 5'000'000;
constexpr std::size_t kept = 4;  ///< figures of a kick

struct World {
  const char* name;
  const char* what;
  Options options;
};
const std::vector<World> worlds = {
    {"nominal", "nominal", {}},
    {"bullet", "Bullet", {{"engine", "bullet"}}},
    {"drawn", "drawn robots", {{"effects", effects}, {"draws", "40"}, {"firstDraw", "1000"}}}};

Options with(Options all, const Options& more) {
  for (const auto& [key, value] : more) all[key] = value;
  return all;
}

/// The middle of what a search found.
Eigen::VectorXd search(const Options& options, std::uint64_t seed, std::int64_t generations) {
  const auto task = makeTask("kick", TaskOptions(options));
  OptimizerOptions how;
  how.population = population;
  how.seed = seed;
  how.stop.maxGenerations = generations;
  Search search(makeOptimizer("cmaes", SearchSpace::of(task->parameters()), how),
                {runsOfEach, runsOfEach, true}, seed);
  while (const auto trial = search.next()) {
    std::vector<double> costs;
    for (const std::uint64_t run : trial->seeds) costs.push_back(task->run(trial->parameters, run).cost);
    search.tell(trial->number, costs);
  }
  return search.optimizer().favourite();
}

Eigen::VectorXd startOf(const Options& options) {
  return SearchSpace::of(makeTask("kick", TaskOptions(options))->parameters()).start;
}

/// Means of tries: metres forward, degrees off, share of falls [%], cost.
std::array<double, kept> measure(const Options& options, const Eigen::VectorXd& kick, std::uint64_t tries) {
  const auto task = makeTask("kick", TaskOptions(options));
  std::array<double, kept> mean{};
  for (std::uint64_t i = 0; i < tries; ++i) {
    const TaskOutcome outcome = task->run(kick, firstMeasured + i);
    const std::map<std::string, double> figures(outcome.figures.begin(), outcome.figures.end());
    const double share = 1 / static_cast<double>(tries);
    mean[0] += share * figures.at("distance");
    mean[1] += share * figures.at("off");
    mean[2] += share * 100 * (1 - figures.at("up"));
    mean[3] += share * outcome.cost;
  }
  return mean;
}

struct Row {
  std::string kick;
  std::map<std::string, std::array<double, kept>> in;  ///< by world
};

std::string line(const Row& row) {
  std::string text = fmt::format("| {} |", row.kick);
  for (const World& world : worlds) {
    const auto& f = row.in.at(world.name);
    text += fmt::format(" {:.2f} | {:.1f} | {:.1f} |", f[0], f[1], f[2]);
  }
  for (const char* world : {"bullet", "drawn"})
    text += fmt::format(" {:.0f} |", row.in.at(world)[3] - row.in.at("nominal")[3]);
  return text + "\n";
}

Row meanOf(const std::vector<Row>& rows, const std::string& name) {
  Row mean{name, {}};
  for (const Row& row : rows)
    for (const auto& [world, figures] : row.in)
      for (std::size_t i = 0; i < kept; ++i)
        mean.in[world][i] += figures[i] / static_cast<double>(rows.size());
  return mean;
}

}  // namespace

int main() {
  const std::uint64_t seeds = environment("SEEDS", 3), measured = environment("MEASURED", 200);
  const auto generations = static_cast<std::int64_t>(environment("GENERATIONS", 80));
  const char* motion = std::getenv("MOTION");
  const Options base{{"type", std::to_string(environment("TYPE", 0))},
                     {"motion", motion ? motion : "kickRight"},
                     {"spread", "0.015"},
                     {"steady", "3"},
                     {"weight", "0.03"}};
  const Options searched = with(base, {{"walk", "0.8"}});
  const auto tried = [&](const std::string& name, const Eigen::VectorXd& kick) {
    Row row{name, {}};
    for (const World& world : worlds) row.in[world.name] = measure(with(base, world.options), kick, measured);
    fmt::print("{}", line(row));
    std::fflush(stdout);
    return row;
  };

  std::string table = "| kick |";
  for (const World& world : worlds) table += fmt::format(" {} [m] | off [deg] | falls [%] |", world.what);
  table += " cost lost on Bullet | on drawn robots |\n|---|";
  for (std::size_t i = 0; i < 3 * worlds.size() + 2; ++i) table += "---|";
  table += "\n" + line(tried("start", startOf(base)));
  std::vector<Row> without, drawn;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    without.push_back(
        tried(fmt::format("without draws, seed {}", seed), search(searched, seed, generations)));
    drawn.push_back(
        tried(fmt::format("with draws, seed {}", seed),
              search(with(searched, {{"effects", effects}, {"draws", drawsOfSearch}}), seed, generations)));
    table += line(without.back()) + line(drawn.back());
  }
  const Row meanWithout = meanOf(without, "**without draws, mean**"),
            meanDrawn = meanOf(drawn, "**with draws, mean**");
  table += line(meanWithout) + line(meanDrawn);

  nlohmann::json figures = nlohmann::json::array();
  for (const auto& [name, row] :
       {std::pair<const char*, const Row&>{"without", meanWithout}, {"with", meanDrawn}})
    for (const World& world : worlds) {
      const auto& f = row.in.at(world.name);
      const std::string of = fmt::format("robust.{}_draws.{}.", name, world.name);
      figures.push_back(figureJson(of + "distance", f[0], "m", "higher"));
      figures.push_back(figureJson(of + "off", f[1], "deg", "lower"));
      figures.push_back(figureJson(of + "falls", f[2], "%", "lower"));
      figures.push_back(figureJson(of + "cost", f[3], "", "lower"));
    }
  int better = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    better += drawn[i].in.at("bullet")[3] < without[i].in.at("bullet")[3];
  const double gain = meanWithout.in.at("bullet")[3] - meanDrawn.in.at("bullet")[3];
  const double elsewhere = meanWithout.in.at("drawn")[3] - meanDrawn.in.at("drawn")[3];
  writeFile("build/bench/robust.json", figures.dump(1) + "\n");
  writeFile(
      "build/bench/robust.md",
      fmt::format(
          "Robot type {}, from `{}`: {} generations of {} candidates with {} runs each, seeds 1 to {}, "
          "once in the nominal world\nand once over {} worlds, of which seven have effects of `{}`. Then {} "
          "tries of each, seeds from {}\non, ball within 3 x 3 cm. The robot then walks for 2 s. The tries "
          "are in the nominal world, on Bullet, and on 40 drawn robots that no search used (draws 1000 to "
          "1039). Falls: the robot leans by more than 30 degrees at the end. Cost: the cost of the search, "
          "lower is better; 30 are a metre. Lost: compared with the nominal world.\n\n{}\n"
          "On Bullet the kick found with draws costs {:.0f} {} in the mean, and less in {} of {} pairs; on "
          "drawn robots {:.0f} {}.\n",
          base.at("type"), base.at("motion"), generations, population, runsOfEach, seeds, drawsOfSearch,
          effects, measured, firstMeasured, table, std::abs(gain), gain > 0 ? "less" : "more", better,
          drawn.size(), std::abs(elsewhere), elsewhere > 0 ? "less" : "more"));
}
