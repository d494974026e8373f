#pragma once
#include <Eigen/Core>
#include <vector>

#include "simulation/physics/tree/BoundedSystem.h"

namespace plumbline::simulation {

/// A row of friction and the row of the push that limits it: |friction| <= coefficient * push.
struct FrictionLimit {
  Eigen::Index friction = 0, push = 0;
  double coefficient = 0;
};

/// Solves with Coulomb's limit as ODE's dContactApprox1 has it, a pyramid whose height is the push that there
/// is without friction; two solutions. Without limits: one.
inline const Eigen::VectorXd& solveWithFriction(BoundedSystem& system,
                                                const std::vector<FrictionLimit>& limits) {
  for (const FrictionLimit& limit : limits) system.lower[limit.friction] = system.upper[limit.friction] = 0;
  system.solve();
  if (limits.empty()) return system.solution();
  for (const FrictionLimit& limit : limits) {
    const double most = limit.coefficient * std::abs(system.solution()[limit.push]);
    system.lower[limit.friction] = -most;
    system.upper[limit.friction] = most;
  }
  return system.solve();
}

}  // namespace plumbline::simulation
