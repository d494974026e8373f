#include "optimization/ParticleSwarm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "math/Random.h"
#include "optimization/Optimizers.h"

namespace plumbline {
namespace {

constexpr double constriction = 0.72984, pull = 2.05;

}  // namespace

ParticleSwarm::ParticleSwarm(SearchSpace space_, ParticleSwarmOptions options_)
    : Optimizer(std::move(space_), options_.stop), options(options_) {
  if (options.population == 0) options.population = 40;
  if (options.population < 4 || options.neighbours < 0)
    throw std::invalid_argument("ParticleSwarm: population " + std::to_string(options.population) +
                                ", neighbours " + std::to_string(options.neighbours) +
                                "; at least 4 and 0 are needed");
  const int n = dimension();
  place.resize(n, options.population);
  speed.resize(n, options.population);
  Random random(options.seed ^ 0xa0761d6478bd642fULL);
  const auto draw = [&](Eigen::Index i) {
    const double low = space().lower[i], high = space().upper[i];
    if (std::isfinite(low) && std::isfinite(high)) return random.uniform(low, high);
    return std::clamp(space().start[i] + space().sigma[i] * random.gaussian(), low, high);
  };
  for (Eigen::Index k = 0; k < place.cols(); ++k)
    for (Eigen::Index i = 0; i < n; ++i) {
      place(i, k) = draw(i);
      speed(i, k) = 0.5 * (draw(i) - place(i, k));
    }
  place.col(0) = space().start;  // what the user believes is worth a try
  ownBest = place;
  ownCost.assign(static_cast<std::size_t>(options.population), std::numeric_limits<double>::infinity());
}

int ParticleSwarm::leaderOf(int particle) const {
  const int size = population(),
            reach = options.neighbours == 0 ? size / 2 : std::min(options.neighbours, size / 2);
  int leader = particle;
  for (int step = -reach; step <= reach; ++step) {
    const int other = (particle + step + size) % size;
    if (ownCost[static_cast<std::size_t>(other)] < ownCost[static_cast<std::size_t>(leader)]) leader = other;
  }
  return leader;
}

void ParticleSwarm::sample(Eigen::MatrixXd& candidates) {
  if (generations() > 0) {
    Random random(options.seed * 0xd1342543de82ef95ULL + static_cast<std::uint64_t>(generations()));
    for (int k = 0; k < population(); ++k) {
      const int leader = leaderOf(k);
      for (Eigen::Index i = 0; i < place.rows(); ++i) {
        const double own = pull * random.uniform() * (ownBest(i, k) - place(i, k));
        const double others = pull * random.uniform() * (ownBest(i, leader) - place(i, k));
        speed(i, k) = constriction * (speed(i, k) + own + others);
        const double next = place(i, k) + speed(i, k);
        place(i, k) = std::clamp(next, space().lower[i], space().upper[i]);
        if (place(i, k) != next) speed(i, k) = 0;
      }
    }
  }
  candidates = place;
}

void ParticleSwarm::update(std::span<const double> costs, std::span<const int>) {
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (costs[k] >= ownCost[k]) continue;
    ownCost[k] = costs[k];
    ownBest.col(static_cast<Eigen::Index>(k)) = place.col(static_cast<Eigen::Index>(k));
  }
  // A swarm pauses at times: only a long pause of all of it is an end.
  const auto [low, high] = std::minmax_element(ownCost.begin(), ownCost.end());
  stillFor = std::max(*high - *low, std::abs(bestBefore - bestCost())) < stop().tolFun ? stillFor + 1 : 0;
  bestBefore = bestCost();
}

StopReason ParticleSwarm::converged() const {
  if (stillFor >= 20) return StopReason::tolFun;
  const Eigen::VectorXd spread =
      (ownBest.rowwise().maxCoeff() - ownBest.rowwise().minCoeff()).cwiseQuotient(space().sigma);
  return spread.maxCoeff() < stop().tolX ? StopReason::tolX : StopReason::none;
}

MAKE_OPTIMIZER(pso,
               {"pso", 30,
                [](const SearchSpace& space, const OptimizerOptions& given) -> std::unique_ptr<Optimizer> {
                  ParticleSwarmOptions options;
                  options.population = given.population;
                  options.seed = given.seed;
                  options.stop = given.stop;
                  return std::make_unique<ParticleSwarm>(space, options);
                }});

}  // namespace plumbline
