// The minimum of a bowl with its bottom at (1, 1), by CMA-ES.
#include <cstdio>

#include "optimization/Cmaes.h"

int main() {
  plumbline::CmaesOptions options{.seed = 7};
  options.stop.targetCost = 1e-10;
  plumbline::Cmaes search(plumbline::SearchSpace::around(Eigen::VectorXd::Zero(2), 0.5), options);
  const double cost = plumbline::minimize(search, [](const Eigen::VectorXd& x) { return (x.array() - 1).square().sum(); });
  std::printf("found: %s\n", cost < 1e-9 ? "yes" : "no");
}
