#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "simulation/physics/tree/BoundedSystem.h"

namespace plumbline::simulation {

/// A row of friction and the row of the push that limits it: |friction| <= coefficient * push.
struct FrictionLimit {
  Eigen::Index friction = 0, push = 0;
  double coefficient = 0;
};

/// Solves with Coulomb's limit as a pyramid over the normal force of the same solution. It iterates from the
/// normal force without friction, to a thousandth and at most ten times, because the problem may have no
/// solution. ODE's dContactApprox1 takes the push of a partial solution instead. Without limits: one
/// solution.
inline const Eigen::VectorXd& solveWithFriction(BoundedSystem& system,
                                                const std::vector<FrictionLimit>& limits) {
  for (const FrictionLimit& limit : limits) system.lower[limit.friction] = system.upper[limit.friction] = 0;
  system.solve();
  for (int round = 0; round < 10 && !limits.empty(); ++round) {
    double change = 0, largest = 0;
    for (const FrictionLimit& limit : limits) {
      const double most = limit.coefficient * std::abs(system.solution()[limit.push]);
      change = std::max(change, std::abs(most - system.upper[limit.friction]));
      largest = std::max(largest, most);
      system.lower[limit.friction] = -most;
      system.upper[limit.friction] = most;
    }
    if (change <= 1e-3 * largest) break;
    system.solve();
  }
  return system.solution();
}

}  // namespace plumbline::simulation
