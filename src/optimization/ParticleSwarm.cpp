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

ParticleSwarm::ParticleSwarm(SearchSpace given, ParticleSwarmOptions options)
    : Optimizer(std::move(given), options.stop), options_(options) {
  if (options_.population == 0) options_.population = 40;
  if (options_.population < 4 || options_.neighbours < 0)
    throw std::invalid_argument("ParticleSwarm: population " + std::to_string(options_.population) +
                                ", neighbours " + std::to_string(options_.neighbours) +
                                "; at least 4 and 0 are needed");
  const int n = dimension();
  place_.resize(n, options_.population);
  speed_.resize(n, options_.population);
  Random random(options_.seed ^ 0xa0761d6478bd642fULL);
  const auto draw = [&](Eigen::Index i) {
    const double low = space().lower[i], high = space().upper[i];
    if (std::isfinite(low) && std::isfinite(high)) return random.uniform(low, high);
    return std::clamp(space().start[i] + space().sigma[i] * random.gaussian(), low, high);
  };
  for (Eigen::Index k = 0; k < place_.cols(); ++k)
    for (Eigen::Index i = 0; i < n; ++i) {
      place_(i, k) = draw(i);
      speed_(i, k) = 0.5 * (draw(i) - place_(i, k));
    }
  place_.col(0) = space().start;  // what the user believes is worth a try
  ownBest_ = place_;
  ownCost_.assign(static_cast<std::size_t>(options_.population), std::numeric_limits<double>::infinity());
}

int ParticleSwarm::leaderOf(int particle) const {
  const int size = population(),
            reach = options_.neighbours == 0 ? size / 2 : std::min(options_.neighbours, size / 2);
  int leader = particle;
  for (int step = -reach; step <= reach; ++step) {
    const int other = (particle + step + size) % size;
    if (ownCost_[static_cast<std::size_t>(other)] < ownCost_[static_cast<std::size_t>(leader)])
      leader = other;
  }
  return leader;
}

void ParticleSwarm::sample(Eigen::MatrixXd& candidates) {
  if (generations() > 0) {
    Random random(options_.seed * 0xd1342543de82ef95ULL + static_cast<std::uint64_t>(generations()));
    for (int k = 0; k < population(); ++k) {
      const int leader = leaderOf(k);
      for (Eigen::Index i = 0; i < place_.rows(); ++i) {
        const double own = pull * random.uniform() * (ownBest_(i, k) - place_(i, k));
        const double others = pull * random.uniform() * (ownBest_(i, leader) - place_(i, k));
        speed_(i, k) = constriction * (speed_(i, k) + own + others);
        const double next = place_(i, k) + speed_(i, k);
        place_(i, k) = std::clamp(next, space().lower[i], space().upper[i]);
        if (place_(i, k) != next) speed_(i, k) = 0;
      }
    }
  }
  candidates = place_;
}

void ParticleSwarm::update(std::span<const double> costs, std::span<const int>) {
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (costs[k] >= ownCost_[k]) continue;
    ownCost_[k] = costs[k];
    ownBest_.col(static_cast<Eigen::Index>(k)) = place_.col(static_cast<Eigen::Index>(k));
  }
  // A swarm pauses at times: only a long pause of all of it is an end.
  const auto [low, high] = std::minmax_element(ownCost_.begin(), ownCost_.end());
  stillFor_ = std::max(*high - *low, std::abs(bestBefore_ - bestCost())) < stop().tolFun ? stillFor_ + 1 : 0;
  bestBefore_ = bestCost();
}

StopReason ParticleSwarm::converged() const {
  if (stillFor_ >= 20) return StopReason::tolFun;
  const Eigen::VectorXd spread =
      (ownBest_.rowwise().maxCoeff() - ownBest_.rowwise().minCoeff()).cwiseQuotient(space().sigma);
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
