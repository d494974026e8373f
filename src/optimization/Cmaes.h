#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <string>

#include "optimization/BoxTransform.h"
#include "optimization/Optimizer.h"

namespace plumbline {

struct CmaesOptions {
  int population = 0;  ///< candidates per generation; 0: 4 + floor(3 ln n); at least 4
  std::uint64_t seed = 1;
  bool active = true;  ///< bad candidates take variance away (negative weights)
  StopCriteria stop;
  /// Generations evaluated at a time. Above 1 a generation is drawn before the costs of earlier ones are
  /// known. Its step is shortened by half of the mean's motion meanwhile, and the step-size path by a quarter
  /// of it. So a step that earlier generations already took does not count as another step in the same
  /// direction.
  int ahead = 1;
};

/// CMA-ES with active covariance update: Hansen, "The CMA Evolution Strategy: A Tutorial" (arXiv:1604.00772,
/// 2016), figure 6 and table 1, cm = 1. Bounds by BoxTransform. The covariance is decomposed anew only after
/// 0.5 / ((c1 + cmu) n) generations. Each generation's numbers depend on seed and generation alone.
class Cmaes : public Optimizer {
public:
  Cmaes(SearchSpace space, CmaesOptions options = {});

  int population() const { return static_cast<int>(weights_.size()); }
  double sigma() const override { return sigma_; }
  Eigen::VectorXd favourite() const override;
  /// Standard deviation of the candidates, per coordinate (bounds aside).
  Eigen::VectorXd deviations() const;

  std::string save() const override;
  void restore(const std::string& state) override;

protected:
  void sample(Eigen::MatrixXd& candidates) override;
  void update(std::span<const double> costs, std::span<const int> order) override;
  StopReason converged() const override;
  bool hasCheckpoint() const override { return ahead() == 1; }
  void forget() override { drawn_.pop_front(); }

private:
  struct Drawn {
    Eigen::MatrixXd z, y;
    Eigen::VectorXd mean;
  };
  void decompose();
  void adaptCovariance(const Drawn& from, std::span<const int> order, bool pathIsShort);
  void remember(std::span<const double> costs, std::span<const int> order);
  template <typename Archive>
  void visitState(Archive&& archive);

  CmaesOptions options_;
  BoxTransform box_;
  int mu_ = 0;
  Eigen::VectorXd weights_;
  double muEff_ = 0, cSigma_ = 0, dSigma_ = 0, cC_ = 0, c1_ = 0, cMu_ = 0, chiN_ = 0;
  std::int64_t decomposeEvery_ = 1;

  // In coordinates whose unit is the first sigma.
  Eigen::VectorXd mean_, pathSigma_, pathC_, scales_;
  Eigen::MatrixXd covariance_, axes_;  // axes: eigenvectors times scales
  std::deque<Drawn> drawn_;            // generations not evaluated yet, the oldest first
  double sigma_ = 1;
  std::int64_t updates_ = 0, decomposedAt_ = 0;
  double lastSpread_ = 0;
  std::deque<double> bests_, medians_;
  bool degenerate_ = false;
};

}  // namespace plumbline
