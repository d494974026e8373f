#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "optimization/Optimizer.h"

namespace plumbline {

struct ParticleSwarmOptions {
  int population = 0;  ///< particles; 0: 40; at least 4
  std::uint64_t seed = 1;
  int neighbours = 2;  ///< on either side of a particle in the ring; 0: everybody knows everybody
  StopCriteria stop;
};

/// Particle swarm with constriction (chi 0.72984, phi 2.05 twice): Clerc and Kennedy, "The particle swarm",
/// IEEE Transactions on Evolutionary Computation 6(1), 2002. Each particle is drawn to its own best place and
/// to the best of its neighbours in a ring (Bratton and Kennedy, "Defining a Standard for Particle Swarm
/// Optimization", 2007). A particle that would leave the box stops at its wall.
class ParticleSwarm : public Optimizer {
public:
  ParticleSwarm(SearchSpace space, ParticleSwarmOptions options = {});
  int population() const { return static_cast<int>(place_.cols()); }

protected:
  void sample(Eigen::MatrixXd& candidates) override;
  void update(std::span<const double> costs, std::span<const int> order) override;
  StopReason converged() const override;

private:
  int leaderOf(int particle) const;

  ParticleSwarmOptions options_;
  Eigen::MatrixXd place_, speed_, ownBest_;
  std::vector<double> ownCost_;
  double bestBefore_ = 0;
  int stillFor_ = 0;
};

}  // namespace plumbline
