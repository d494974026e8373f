// Evaluations to 1e-8 and time per generation of the optimisers, beside the figures of libcmaes and
// pagmo 2.18 (measured with the same functions; where libpagmo-dev is installed its cmaes is measured here as
// well).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "optimization/Cmaes.h"
#include "optimization/Functions.h"
#include "optimization/Xnes.h"

using namespace plumbline;
using Eigen::VectorXd;

namespace {

nlohmann::json report = nlohmann::json::array();

void add(const std::string& name, double value, const char* unit, double peer, const char* peerName) {
  std::printf("%-40s %10.6g %-12s %s %g\n", name.c_str(), value, unit, peerName, peer);
  report.push_back({{"name", "optimisers." + name},
                    {"value", value},
                    {"unit", unit},
                    {"better", "lower"},
                    {"target", peer},
                    {"peer", peerName},
                    {"peer_value", peer}});
}

/// Of as many runs as are given, those that did not get there counting as the longest.
template <typename T, typename Options>
double medianEvaluations(double (*cost)(const VectorXd&), int n, double start, int runs, Options options) {
  std::vector<double> counts;
  for (int seed = 1; seed <= runs; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    options.stop.targetCost = 1e-8;
    options.stop.maxEvaluations = 1'000'000;
    T optimizer(SearchSpace::around(VectorXd::Constant(n, start), 0.5), options);
    minimize(optimizer, cost);
    counts.push_back(optimizer.bestCost() <= 1e-8 ? static_cast<double>(optimizer.evaluations()) : 1e9);
  }
  std::sort(counts.begin(), counts.end());
  return counts[counts.size() / 2];
}

double cmaesEvaluations(double (*cost)(const VectorXd&), int n, double start, int population) {
  CmaesOptions options;
  options.population = population;
  return medianEvaluations<Cmaes>(cost, n, start, 9, options);
}

double xnesEvaluations(double (*cost)(const VectorXd&), double start) {
  return medianEvaluations<Xnes>(cost, 10, start, 5, XnesOptions{});
}

template <typename T, typename Options>
double millisecondsPerGeneration(int n) {
  Options options;
  options.population = 30;
  T cmaes(SearchSpace::around(VectorXd::Constant(n, 1), 0.5), options);
  std::vector<double> costs(30);
  double seconds = 0;
  constexpr int generations = 200;
  for (int i = 0; i < generations; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const Eigen::MatrixXd& candidates = cmaes.ask();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (int k = 0; k < 30; ++k) costs[static_cast<std::size_t>(k)] = sphere(candidates.col(k));
    const auto again = std::chrono::steady_clock::now();
    cmaes.tell(costs);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - again).count();
  }
  return 1e3 * seconds / generations;
}

}  // namespace

int main() {
  struct Case {
    const char* name;
    double (*cost)(const VectorXd&);
    int n;
    double start, libcmaes;
  };
  // Populations by default, as in libcmaes.
  for (const Case& c :
       {Case{"sphere", sphere, 10, 1, 1440}, Case{"ellipsoid", ellipsoid, 10, 1, 4230},
        Case{"rosenbrock", rosenbrock, 10, 0, 5500}, Case{"sphere", sphere, 40, 1, 5370},
        Case{"ellipsoid", ellipsoid, 40, 1, 44000}, Case{"rosenbrock", rosenbrock, 40, 0, 58000}})
    add("cmaes." + std::string(c.name) + std::to_string(c.n) + ".evaluations",
        cmaesEvaluations(c.cost, c.n, c.start, 0), "evaluations", c.libcmaes, "libcmaes aCMA");
  for (const Case& c : {Case{"sphere", sphere, 10, 1, 2960}, Case{"ellipsoid", ellipsoid, 10, 1, 7672},
                        Case{"rosenbrock", rosenbrock, 10, 0, 9742}, Case{"sphere", sphere, 40, 1, 8136},
                        Case{"ellipsoid", ellipsoid, 40, 1, 76900}})
    add("cmaes." + std::string(c.name) + std::to_string(c.n) + ".evaluations_of_30",
        cmaesEvaluations(c.cost, c.n, c.start, 30), "evaluations", c.libcmaes, "pagmo cmaes");
  add("cmaes.generation96", millisecondsPerGeneration<Cmaes, CmaesOptions>(96), "ms", 3.5, "pagmo cmaes");
  add("cmaes.generation210", millisecondsPerGeneration<Cmaes, CmaesOptions>(210), "ms", 37, "pagmo cmaes");

  add("xnes.sphere10.evaluations", xnesEvaluations(sphere, 1), "evaluations", 15500, "pagmo xnes");
  add("xnes.ellipsoid10.evaluations", xnesEvaluations(ellipsoid, 1), "evaluations", 21900, "pagmo xnes");
  add("xnes.rosenbrock10.evaluations", xnesEvaluations(rosenbrock, 0), "evaluations", 22200, "pagmo xnes");
  add("xnes.generation96", millisecondsPerGeneration<Xnes, XnesOptions>(96), "ms", 0.7, "pagmo xnes");
  add("xnes.generation210", millisecondsPerGeneration<Xnes, XnesOptions>(210), "ms", 6.6, "pagmo xnes");
  std::ofstream("build/bench/optimisers.json") << report.dump(1) << "\n";
}
