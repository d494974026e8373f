// The optimisers beside pagmo's in one run: evaluations to 1e-8 (median of seeds), time of a generation, what
// averaging only the better half saves, and the farm in simulated time. build/bench/optimisation.json.
// Arguments: seeds, largest dimension of the evaluations, largest of pagmo's, seeds of the evaluations above
// 40 dimensions. Or `speed`: prints only what evaluations of motions cost, in two minutes.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <vector>

#include "../../optimization/Functions.h"
#include "../../optimization/farm/SimulatedFarm.h"
#include "Peer.h"
#include "Speed.h"
#include "optimization/Cmaes.h"
#include "optimization/Optimizers.h"
#include "optimization/Search.h"

namespace {

using namespace plumbline;
using bench::Function;
using Eigen::VectorXd;

constexpr double target = 1e-8;
nlohmann::json report = nlohmann::json::array();

bool isWhole = true;  ///< else the figures are not those of the page, and are only printed

void write() {
  if (!isWhole) return;
  std::ofstream("build/bench/optimisation.json") << report.dump(1) << "\n";
}

void add(const std::string& name, double value, const char* unit, const char* better, double goal,
         const std::string& peer = "", double peerValue = 0) {
  fmt::print("{:<52} {:>11.5g} {:<12} {} {}\n", name, value, unit, peer,
             peer.empty() ? "" : fmt::format("{:.5g}", peerValue));
  std::fflush(stdout);
  nlohmann::json one{{"name", "optimisation." + name}, {"value", value}, {"unit", unit}, {"better", better}};
  if (goal > 0) one["target"] = goal;
  if (!peer.empty()) one["peer"] = peer, one["peer_value"] = peerValue;
  report.push_back(one);
  write();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

struct Case {
  const char* name;
  Function function;
  double start;
  double deviation = bench::firstDeviation;
};
constexpr Case cases[] = {{"sphere", sphere, 1},
                          {"ellipsoid", ellipsoid, 1},
                          {"rosenbrock", rosenbrock, 0},
                          {"rastrigin", rastrigin, 1, bench::rastriginDeviation}};

double evaluations(const std::string& name, const Case& c, int n, int population, std::uint64_t seed,
                   double most) {
  OptimizerOptions options;
  options.population = population;
  options.seed = seed;
  options.stop.targetCost = target;
  options.stop.maxEvaluations = static_cast<std::int64_t>(most);
  const auto optimizer =
      makeOptimizer(name, SearchSpace::around(VectorXd::Constant(n, c.start), c.deviation), options);
  minimize(*optimizer, c.function);
  return optimizer->bestCost() <= target ? static_cast<double>(optimizer->evaluations()) : 1e9;
}

/// Of a generation of 30 around 10 in 40 dimensions: 4000 at its middle.
double firstBest(std::uint64_t seed) {
  OptimizerOptions options;
  options.population = 30;
  options.seed = seed;
  const auto optimizer =
      makeOptimizer("cmaes", SearchSpace::around(VectorXd::Constant(40, 10), bench::firstDeviation), options);
  const Eigen::MatrixXd all = optimizer->ask();
  double best = sphere(all.col(0));
  for (int k = 1; k < 30; ++k) best = std::min(best, sphere(all.col(k)));
  return best;
}

/// Both begin in the same place with the same deviation: the best of the first generation is alike. Ends the
/// benchmark where it is not, as its figures would say nothing.
void checkBeginning(int seeds) {
  std::vector<double> ours, peers;
  for (int seed = 1; seed <= seeds; ++seed) {
    ours.push_back(firstBest(static_cast<std::uint64_t>(seed)));
    peers.push_back(
        bench::runPeer("cmaes", sphere, 40, 10, 30, 0, 30 * 3, static_cast<unsigned>(seed)).firstBest);
  }
  add("cmaes.sphere40.best_of_first_generation", median(ours), "", "lower", 0, "pagmo cmaes", median(peers));
  if (std::abs(median(ours) / median(peers) - 1) < 0.02) return;
  fmt::print(stderr, "the first generations differ: they do not begin alike\n");
  std::exit(1);
}

double arrived(const std::vector<double>& evaluations) {
  return static_cast<double>(std::ranges::count_if(evaluations, [](double one) { return one < 1e9; }));
}

/// How many seeds arrive at all where there are many minima, and what restarts make of it: from the same
/// deviation and from one that is too small.
void compareRastrigin(const Case& c, int n, int population, const std::vector<double>& ours,
                      const std::vector<double>& peers, int seeds) {
  constexpr double most = 400'000;
  const std::string of = fmt::format("{}{}", c.name, n);
  add(fmt::format("cmaes.{}.arrived_of_{}_seeds", of, seeds), arrived(ours), "", "higher", 0, "pagmo cmaes",
      arrived(peers));
  Case narrow = c;
  narrow.deviation = bench::firstDeviation;
  for (const auto& [word, from] : {std::pair{"", c}, std::pair{"_from_too_near", narrow}}) {
    std::vector<double> restarted;
    for (int seed = 1; seed <= seeds; ++seed)
      restarted.push_back(
          evaluations("ipop-cmaes", from, n, population, static_cast<std::uint64_t>(seed), most));
    add(fmt::format("ipop-cmaes.{}.arrived_of_{}_seeds{}", of, seeds, word), arrived(restarted), "", "higher",
        0);
    add(fmt::format("ipop-cmaes.{}.evaluations_of_{}{}", of, population, word), median(restarted),
        "evaluations", "lower", 0);
  }
}

/// Both with the same population. manySeeds: where a seed takes seconds; above 40 dimensions it takes
/// minutes.
void compareEvaluations(int manySeeds, int fewSeeds, int largest, int largestPeer) {
  for (const int n : {10, 40, 96, 210})
    for (const Case& c : cases) {
      const int seeds = n > 40 ? fewSeeds : manySeeds;
      if (n > largest || (c.function == rastrigin && n > 10)) continue;
      const int population = c.function == rastrigin ? 200 : 30;
      const double most = c.function == sphere ? 60.0 * n * population : 400.0 * n * n + 20000;
      std::vector<double> ours, peers;
      for (int seed = 1; seed <= seeds; ++seed)
        ours.push_back(evaluations("cmaes", c, n, population, static_cast<std::uint64_t>(seed), most));
      // pagmo stops at a number of generations only; who needs three times as many as ours has lost anyway.
      const double peerMost = std::min(most, 3 * median(ours));
      for (int seed = 1; seed <= seeds && n <= largestPeer; ++seed)
        peers.push_back(bench::runPeer("cmaes", c.function, n, c.start, population, target, peerMost,
                                       static_cast<unsigned>(seed), c.deviation)
                            .evaluations);
      const std::string name = fmt::format("cmaes.{}{}.evaluations_of_{}", c.name, n, population);
      if (c.function == rastrigin) compareRastrigin(c, n, population, ours, peers, seeds);
      if (peers.empty())
        add(name, median(ours), "evaluations", "lower", 0);
      else if (median(peers) >= 1e9)  // nothing is known of it but that
        add(name, median(ours), "evaluations", "lower", 0, "pagmo cmaes does not reach it within", peerMost);
      else
        add(name, median(ours), "evaluations", "lower", median(peers), "pagmo cmaes", median(peers));
      const double separable = evaluations("sep-cmaes", c, n, population, 1, most);
      if (separable < 1e9)
        add(fmt::format("sep-cmaes.{}{}.evaluations_of_{}_by_seed_1", c.name, n, population), separable,
            "evaluations", "lower", 0);
    }
}

double secondsPerGeneration(const std::string& name, int n, int generations) {
  OptimizerOptions options;
  options.population = 30;
  const auto optimizer =
      makeOptimizer(name, SearchSpace::around(VectorXd::Constant(n, 1), bench::firstDeviation), options);
  std::vector<double> costs(30);
  const double begin = bench::processorSeconds();
  for (int g = 0; g < generations; ++g) {
    const Eigen::MatrixXd& all = optimizer->ask();
    for (int k = 0; k < 30; ++k) costs[static_cast<std::size_t>(k)] = sphere(all.col(k));
    optimizer->tell(costs);
  }
  return (bench::processorSeconds() - begin) / generations;
}

void compareTime() {
  for (const std::string name : {"cmaes", "xnes"})
    for (const int n : {10, 40, 96, 210}) {
      const int generations = n > 100 ? 60 : 200;
      const auto peer = bench::runPeer(name, sphere, n, 1, 30, 0, 30.0 * generations, 1);
      std::vector<double> times;
      for (int i = 0; i < 3; ++i) times.push_back(1e3 * secondsPerGeneration(name, n, generations));
      const double peerTime = 1e3 * peer.seconds / std::max(1.0, peer.generations);
      add(fmt::format("{}.generation{}", name, n), median(times), "ms", "lower", 0.5 * peerTime,
          "pagmo " + name, peerTime);
    }
  // Thesis, table 3.7: 20 clients, evaluations that took 0.53 s each, so 30 of them 0.8 s.
  add("xnes.share_of_a_generation96", 100 * secondsPerGeneration("xnes", 96, 200) / 0.8, "%", "lower", 1,
      "thesis", 71.2);
}

/// Runs until the middle of the distribution has a true cost of 0.05 where each run has noise of deviation
/// 0.3.
double runsUnderNoise(const Averaging& averaging, std::uint64_t seed) {
  CmaesOptions options;
  options.population = 20;
  options.seed = seed;
  options.stop.maxGenerations = 2000;
  options.stop.tolFun = options.stop.tolX = 0;
  Search search(std::make_unique<Cmaes>(SearchSpace::around(VectorXd::Constant(10, 1), 0.5), options),
                averaging, seed);
  while (const auto trial = search.next()) {
    std::vector<double> costs;
    for (const std::uint64_t one : trial->seeds) {
      // Half of the noise is the start's, which the same seed repeats, half of it is the candidate's own.
      Random start(one), own(one * 31 + static_cast<std::uint64_t>(trial->candidate));
      costs.push_back(sphere(trial->parameters) + 0.3 * std::sqrt(0.5) * (start.gaussian() + own.gaussian()));
    }
    search.tell(trial->number, costs);
    if (sphere(search.optimizer().favourite()) < 0.05) break;
  }
  return sphere(search.optimizer().favourite()) < 0.05 ? static_cast<double>(search.runs()) : 1e9;
}

void averaging(int seeds) {
  const auto of = [&](const Averaging& a) {
    std::vector<double> runs;
    for (int seed = 1; seed <= seeds; ++seed)
      runs.push_back(runsUnderNoise(a, static_cast<std::uint64_t>(seed)));
    return median(runs);
  };
  const double always = of({30, 30, false});
  add("noise.runs_30_of_all", always, "runs", "lower", 0);
  add("noise.runs_30_of_all_same_seeds", of({30, 30, true}), "runs", "lower", 0, "30 of all", always);
  add("noise.runs_10_of_all_30_of_best", of({10, 30, true}), "runs", "lower", 0, "30 of all", always);
  add("noise.runs_2_of_all_6_of_best", of({2, 6, true}), "runs", "lower", 0, "30 of all", always);
}

void farms(int seeds) {
  for (const Case& c : {cases[0], cases[1], cases[2]})
    for (const int n : {10, 40}) {
      if (n == 40 && c.function != sphere) continue;
      std::vector<double> counts[2], efficiencies[2];
      for (int seed = 1; seed <= seeds; ++seed)
        for (const int kind : {0, 1}) {
          CmaesOptions options;
          options.population = kind == 0 ? 30 : 18;
          options.ahead = kind == 0 ? 1 : 3;
          options.seed = static_cast<std::uint64_t>(seed);
          options.stop.targetCost = target;
          options.stop.maxEvaluations = 100'000;
          Search search(
              std::make_unique<Cmaes>(
                  SearchSpace::around(VectorXd::Constant(n, c.start), bench::firstDeviation), options),
              {}, options.seed);
          farm::SimulatedFarm farm;
          farm.seed = options.seed;
          const auto result =
              farm.run(search, [&](const Trial& trial) { return c.function(trial.parameters); });
          counts[kind].push_back(
              search.optimizer().bestCost() <= target ? static_cast<double>(search.trials()) : 1e9);
          efficiencies[kind].push_back(100 * result.efficiency);
        }
      const std::string name = fmt::format("farm30.{}{}", c.name, n);
      add(name + ".efficiency", median(efficiencies[1]), "%", "higher", 95, "barrier",
          median(efficiencies[0]));
      add(name + ".evaluations", median(counts[1]), "evaluations", "lower", 1.1 * median(counts[0]),
          "barrier", median(counts[0]));
    }
}

/// Part of the thesis's figure 3.26 that does not depend on the number of cores: what an evaluation costs,
/// and what the chain adds to it, with least and most of the passes. A walk takes as long as several kicks.
void evaluationsOfMotions() {
  struct Motion {
    const char *name, *task;
    std::map<std::string, std::string> options;
    int generations = 8;
  };
  constexpr int passes = 5;
  for (const auto& [name, task, options, generations] :
       {Motion{"standUp", "standUp", {{"direction", "front"}}},
        {"kick", "kick", {{"motion", "kickLong"}, {"walk", "0.8"}}},
        {"kick_with_two_seconds_of_walk", "kick", {{"motion", "kickLong"}}},
        {"walk", "walk", {{"direction", "forward"}}, 1}}) {
    const bench::TaskSpeed speed = bench::speedOf(task, options, generations, passes);
    const std::string chain = fmt::format("speed.{}.chain_above_bare", name);
    add(fmt::format("speed.{}.runs_a_second_of_one_core", name), 1 / speed.farmed, "1/s", "higher", 0);
    add(chain, 100 * speed.overhead.median, "%", "lower", 5);
    add(chain + "_least_of_5", 100 * speed.overhead.least, "%", "lower", 0);
    add(chain + "_most_of_5", 100 * speed.overhead.most, "%", "lower", 0);
  }
  const bench::CycleTimes cycle = bench::cycleTimes(0, 5000);
  add("speed.cycle.physics", 1e6 * cycle.physics, "us", "lower", 0);
  add("speed.cycle.walk_engine", 1e6 * cycle.walk, "us", "lower", 0);
  add("speed.cycle.joint_control", 1e6 * cycle.control, "us", "lower", 0);
  add("speed.walk.simulated_seconds_a_second_of_one_core",
      0.02 / (cycle.physics + cycle.walk + cycle.control), "", "higher", 0);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "speed") {
    isWhole = false;
    evaluationsOfMotions();
    return 0;
  }
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 15;
  const int largest = argc > 2 ? std::atoi(argv[2]) : 210, largestPeer = argc > 3 ? std::atoi(argv[3]) : 210;
  const int fewSeeds = argc > 4 ? std::atoi(argv[4]) : seeds;
  std::ofstream("build/bench/optimisation.md") << fmt::format(
      "Evaluations to 1e-8: median of {} seeds, of {} above 40 dimensions, ours up to {} dimensions, pagmo's "
      "up "
      "to {}, from the same place "
      "with the same first\ndeviation. Times are of the processor. `real_farm30`: thirty processes of "
      "bin/optworker "
      "whose evaluations sleep.\n`sep-cmaes`: seed 1 alone, where that arrives.\n"
      "Motions by hand and found: [optimisation-motions](optimisation-motions.md). "
      "Speed-up by the number of workers: [clients](clients.md).\n",
      seeds, fewSeeds, largest, largestPeer);
  checkBeginning(seeds);
  compareTime();
  evaluationsOfMotions();
  farms(seeds);
  averaging(seeds);
  compareEvaluations(seeds, fewSeeds, largest, largestPeer);
}
