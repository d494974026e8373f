#include "optimization/Xnes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/Gaussians.h"
#include "optimization/LowRankExponential.h"
#include "optimization/Optimizers.h"

namespace plumbline {

Xnes::Xnes(SearchSpace space_, XnesOptions options_)
    : Optimizer(std::move(space_), options_.stop), options(options_), box(space().lower, space().upper) {
  const int n = dimension();
  if (options.population == 0) options.population = 4 + static_cast<int>(std::floor(3 * std::log(n)));
  if (options.population < 4)
    throw std::invalid_argument("Xnes: population " + std::to_string(options.population) +
                                ", at least 4 are needed");
  const int lambda = options.population;
  utilities.resize(lambda);
  for (int i = 0; i < lambda; ++i)
    utilities[i] = std::max(0.0, std::log(lambda / 2.0 + 1) - std::log(i + 1.0));
  utilities /= utilities.sum();
  utilities.array() -= 1.0 / lambda;
  rate = 3 * (3 + std::log(n)) / (5 * n * std::sqrt(n));
  mean = box.fromBox(space().start).cwiseQuotient(space().sigma);
  shape = Eigen::MatrixXd::Identity(n, n);
  z.resize(n, lambda);
}

Eigen::VectorXd Xnes::favourite() const { return box.toBox(mean.cwiseProduct(space().sigma)); }

void Xnes::sample(Eigen::MatrixXd& candidates) {
  Random random(options.seed * 0xd1342543de82ef95ULL + static_cast<std::uint64_t>(generations()));
  fillGaussian(random, std::span(z.data(), static_cast<std::size_t>(z.size())));
  step.noalias() = shape * z;
  candidates.resize(step.rows(), step.cols());
  for (Eigen::Index k = 0; k < candidates.cols(); ++k)
    for (Eigen::Index i = 0; i < candidates.rows(); ++i)
      candidates(i, k) = space().sigma[i] * (mean[i] + sigma_ * step(i, k));
  if (!box.bounds()) return;
  for (Eigen::Index k = 0; k < candidates.cols(); ++k)
    for (Eigen::Index i = 0; i < candidates.rows(); ++i) candidates(i, k) = box.toBox(i, candidates(i, k));
}

void Xnes::update(std::span<const double> costs, std::span<const int> order) {
  const int n = dimension(), lambda = population();
  Eigen::VectorXd u(lambda);
  for (int i = 0; i < lambda; ++i) u[order[static_cast<std::size_t>(i)]] = utilities[i];
  // The utilities add up to 0, so the gradient of the covariance is z diag(u) z'.
  const double gradientSigma = (z.colwise().squaredNorm().transpose().cwiseProduct(u)).sum() / n;
  mean.noalias() += sigma_ * (step * u);
  growByExponential(shape, step, z, 0.5 * rate * u);
  shape *= std::exp(-0.5 * rate * gradientSigma);
  sigma_ *= std::exp(0.5 * rate * gradientSigma);

  const double best = costs[static_cast<std::size_t>(order[0])];
  lastSpread = costs[static_cast<std::size_t>(order[static_cast<std::size_t>(lambda) - 1])] - best;
  stillFor = std::max(lastSpread, std::abs(best - bestBefore)) < stop().tolFun ? stillFor + 1 : 0;
  bestBefore = best;
}

StopReason Xnes::converged() const {
  if (stillFor >= 10 + 30 * dimension() / population()) return StopReason::tolFun;
  const double spread = sigma_ * std::sqrt(shape.rowwise().squaredNorm().maxCoeff());
  if (!std::isfinite(spread) || spread > 1e4) return StopReason::condition;
  return spread < stop().tolX ? StopReason::tolX : StopReason::none;
}

MAKE_OPTIMIZER(xnes,
               {"xnes", 20,
                [](const SearchSpace& space, const OptimizerOptions& given) -> std::unique_ptr<Optimizer> {
                  return std::make_unique<Xnes>(space, XnesOptions{given.population, given.seed, given.stop});
                }});

}  // namespace plumbline
