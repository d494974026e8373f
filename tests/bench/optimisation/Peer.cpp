#include "Peer.h"

#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/xnes.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

namespace plumbline::bench {
namespace {

constexpr double halfWidth = 100;  // of the box: nothing comes near to its edge

struct Problem {
  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    return {function(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())))};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {pagmo::vector_double(dimension, -halfWidth), pagmo::vector_double(dimension, halfWidth)};
  }
  Function function = nullptr;
  std::size_t dimension = 1;
};

/// pagmo begins at the best of a population: all of them are drawn around the same start here.
pagmo::population begin(const Problem& problem, double start, int size, unsigned seed) {
  pagmo::population population(pagmo::problem(problem), 0U, seed);
  const pagmo::vector_double x(problem.dimension, start);
  for (int i = 0; i < size; ++i) population.push_back(x);
  return population;
}

template <typename Algorithm>
PeerRun run(const Algorithm& algorithm, pagmo::population population, int size, double target) {
  pagmo::algorithm wrapped(algorithm);
  wrapped.set_verbosity(1);
  PeerRun result;
  const double before = processorSeconds();
  wrapped.evolve(population);
  result.seconds = processorSeconds() - before;
  result.evaluations = 1e9;
  for (const auto& line : wrapped.template extract<Algorithm>()->get_log()) {
    ++result.generations;
    const auto evaluations = static_cast<double>(std::get<1>(line));
    result.best = std::get<2>(line);
    if (evaluations <= size) result.firstBest = result.best;
    if (result.best > target) continue;
    result.evaluations = evaluations;
    break;
  }
  return result;
}

}  // namespace

PeerRun runPeer(const std::string& algorithm, Function function, int dimension, double start, int population,
                double target, double maxEvaluations, unsigned seed, double deviation) {
  const Problem problem{function, static_cast<std::size_t>(dimension)};
  const auto generations = static_cast<unsigned>(maxEvaluations / population);
  pagmo::population first = begin(problem, start, population, seed);
  // It begins with equal costs, which its tolerances would take for the end.
  // Its sigma is a share of the box's width, for both.
  const double sigma = deviation / (2 * halfWidth);
  if (algorithm == "xnes")
    return run(pagmo::xnes(generations, -1, -1, -1, sigma, 0, 0, false, false, seed), first, population,
               target);
  return run(pagmo::cmaes(generations, -1, -1, -1, -1, sigma, 0, 0, false, false, seed), first, population,
             target);
}

}  // namespace plumbline::bench
