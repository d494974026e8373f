#include "optimization/Xnes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/Gaussians.h"
#include "optimization/LowRankExponential.h"
#include "optimization/Optimizers.h"

namespace plumbline {

Xnes::Xnes(SearchSpace given, XnesOptions options)
    : Optimizer(std::move(given), options.stop), options_(options), box_(space().lower, space().upper) {
  const int n = dimension();
  if (options_.population == 0) options_.population = 4 + static_cast<int>(std::floor(3 * std::log(n)));
  if (options_.population < 4)
    throw std::invalid_argument("Xnes: population " + std::to_string(options_.population) +
                                ", at least 4 are needed");
  const int lambda = options_.population;
  utilities_.resize(lambda);
  for (int i = 0; i < lambda; ++i)
    utilities_[i] = std::max(0.0, std::log(lambda / 2.0 + 1) - std::log(i + 1.0));
  utilities_ /= utilities_.sum();
  utilities_.array() -= 1.0 / lambda;
  rate_ = 3 * (3 + std::log(n)) / (5 * n * std::sqrt(n));
  mean_ = box_.fromBox(space().start).cwiseQuotient(space().sigma);
  shape_ = Eigen::MatrixXd::Identity(n, n);
  z_.resize(n, lambda);
}

Eigen::VectorXd Xnes::favourite() const { return box_.toBox(mean_.cwiseProduct(space().sigma)); }

void Xnes::sample(Eigen::MatrixXd& candidates) {
  Random random(options_.seed * 0xd1342543de82ef95ULL + static_cast<std::uint64_t>(generations()));
  fillGaussian(random, std::span(z_.data(), static_cast<std::size_t>(z_.size())));
  step_.noalias() = shape_ * z_;
  candidates.resize(step_.rows(), step_.cols());
  for (Eigen::Index k = 0; k < candidates.cols(); ++k)
    for (Eigen::Index i = 0; i < candidates.rows(); ++i)
      candidates(i, k) = space().sigma[i] * (mean_[i] + sigma_ * step_(i, k));
  if (!box_.bounds()) return;
  for (Eigen::Index k = 0; k < candidates.cols(); ++k)
    for (Eigen::Index i = 0; i < candidates.rows(); ++i) candidates(i, k) = box_.toBox(i, candidates(i, k));
}

void Xnes::update(std::span<const double> costs, std::span<const int> order) {
  const int n = dimension(), lambda = population();
  Eigen::VectorXd u(lambda);
  for (int i = 0; i < lambda; ++i) u[order[static_cast<std::size_t>(i)]] = utilities_[i];
  // The utilities add up to 0, so the gradient of the covariance is z diag(u) z'.
  const double gradientSigma = (z_.colwise().squaredNorm().transpose().cwiseProduct(u)).sum() / n;
  mean_.noalias() += sigma_ * (step_ * u);
  growByExponential(shape_, step_, z_, 0.5 * rate_ * u);
  shape_ *= std::exp(-0.5 * rate_ * gradientSigma);
  sigma_ *= std::exp(0.5 * rate_ * gradientSigma);

  const double best = costs[static_cast<std::size_t>(order[0])];
  lastSpread_ = costs[static_cast<std::size_t>(order[static_cast<std::size_t>(lambda) - 1])] - best;
  stillFor_ = std::max(lastSpread_, std::abs(best - bestBefore_)) < stop().tolFun ? stillFor_ + 1 : 0;
  bestBefore_ = best;
}

StopReason Xnes::converged() const {
  if (stillFor_ >= 10 + 30 * dimension() / population()) return StopReason::tolFun;
  const double spread = sigma_ * std::sqrt(shape_.rowwise().squaredNorm().maxCoeff());
  if (!std::isfinite(spread) || spread > 1e4) return StopReason::condition;
  return spread < stop().tolX ? StopReason::tolX : StopReason::none;
}

MAKE_OPTIMIZER(xnes,
               {"xnes", 20,
                [](const SearchSpace& space, const OptimizerOptions& given) -> std::unique_ptr<Optimizer> {
                  return std::make_unique<Xnes>(space, XnesOptions{given.population, given.seed, given.stop});
                }});

}  // namespace plumbline
