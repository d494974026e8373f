#include "optimization/ParticleSwarm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "optimization/Functions.h"

namespace plumbline {
namespace {

using Eigen::VectorXd;

/// The functions' minimum moved off the middle of the box, where the swarm starts.
template <double (*cost)(const VectorXd&)>
double moved(const VectorXd& x) {
  return cost(x - VectorXd::Constant(x.size(), 1.3));
}

ParticleSwarm swarm(int n, std::uint64_t seed = 1, int neighbours = 2) {
  ParticleSwarmOptions options;
  options.seed = seed;
  options.neighbours = neighbours;
  options.stop.targetCost = 1e-8;
  options.stop.maxEvaluations = 200'000;
  return {SearchSpace::box(VectorXd::Constant(n, -5), VectorXd::Constant(n, 5)), options};
}

TEST(ParticleSwarm, findsTheMinimum) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    ParticleSwarm s = swarm(10, seed);
    minimize(s, moved<sphere>);
    EXPECT_EQ(s.stopReason(), StopReason::targetCost);
    EXPECT_LT(s.evaluations(), 25'000);
    EXPECT_NEAR(s.best()[3], 1.3, 1e-3);
    ParticleSwarm e = swarm(10, seed);
    minimize(e, moved<ellipsoid>);
    EXPECT_EQ(e.stopReason(), StopReason::targetCost);
  }
}

TEST(ParticleSwarm, theRingIsSlowerButSeesMore) {
  ParticleSwarm ring = swarm(10), everybody = swarm(10, 1, 0);
  minimize(ring, moved<sphere>);
  minimize(everybody, moved<sphere>);
  EXPECT_LT(everybody.evaluations(), ring.evaluations());
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ParticleSwarm s = swarm(4, seed);
    minimize(s, moved<rastrigin>);
    found += s.bestCost() < 1e-6;
  }
  EXPECT_EQ(found, 5);
}

TEST(ParticleSwarm, staysInTheBox) {
  ParticleSwarm s = swarm(3);
  while (!s.isDone()) {
    const Eigen::MatrixXd& candidates = s.ask();
    ASSERT_LE(candidates.cwiseAbs().maxCoeff(), 5);
    std::vector<double> costs;
    for (Eigen::Index k = 0; k < candidates.cols(); ++k) costs.push_back(16 + candidates.col(k).sum());
    s.tell(costs);
  }
  EXPECT_EQ(s.best(), VectorXd::Constant(3, -5));
  EXPECT_EQ(s.stopReason(), StopReason::tolX);
}

TEST(ParticleSwarm, sameSeedSameBytesAndTheStartIsTried) {
  ParticleSwarm a = swarm(4, 3), b = swarm(4, 3), c = swarm(4, 4);
  minimize(a, rosenbrock);
  minimize(b, rosenbrock);
  minimize(c, rosenbrock);
  EXPECT_EQ(a.best(), b.best());
  EXPECT_NE(a.best(), c.best());
  ParticleSwarm d = swarm(4);
  EXPECT_EQ(VectorXd(d.ask().col(0)), VectorXd::Zero(4));
}

}  // namespace
}  // namespace plumbline
