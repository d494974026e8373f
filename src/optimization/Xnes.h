#pragma once
#include <Eigen/Core>
#include <cstdint>

#include "optimization/BoxTransform.h"
#include "optimization/Optimizer.h"

namespace plumbline {

struct XnesOptions {
  int population = 0;  ///< candidates per generation; 0: 4 + floor(3 ln n); at least 4
  std::uint64_t seed = 1;
  StopCriteria stop;
};

/// Exponential natural evolution strategy: Glasmachers, Schaul, Sun, Wierstra, Schmidhuber, "Exponential
/// Natural Evolution Strategies", GECCO 2010, algorithm 1 and its learning rates. The gradient of the shape
/// has the rank of the population, so its exponential is taken there (LowRankExponential): no generation
/// costs more than O(n^2 population). Bounds by BoxTransform.
class Xnes : public Optimizer {
public:
  Xnes(SearchSpace space, XnesOptions options = {});

  int population() const { return static_cast<int>(utilities_.size()); }
  double sigma() const override { return sigma_; }
  Eigen::VectorXd favourite() const override;

protected:
  void sample(Eigen::MatrixXd& candidates) override;
  void update(std::span<const double> costs, std::span<const int> order) override;
  StopReason converged() const override;

private:
  XnesOptions options_;
  BoxTransform box_;
  Eigen::VectorXd utilities_, mean_;
  Eigen::MatrixXd shape_,
      z_;                 ///< shape: candidates are mean + sigma * shape * z, in units of the first sigma
  Eigen::MatrixXd step_;  ///< shape * z of this generation
  double sigma_ = 1, rate_ = 0;
  double lastSpread_ = 0, bestBefore_ = 0;
  int stillFor_ = 0;
};

}  // namespace plumbline
