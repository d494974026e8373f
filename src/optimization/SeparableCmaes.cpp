#include "optimization/SeparableCmaes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/Random.h"

namespace plumbline {
namespace {

constexpr double mostGrowth = 1e4, worstCondition = 1e14;  // as in Cmaes

}  // namespace

SeparableCmaes::SeparableCmaes(SearchSpace given, const OptimizerOptions& options)
    : Optimizer(std::move(given), options.stop), seed_(options.seed), box_(space().lower, space().upper) {
  const double n = dimension();
  population_ =
      options.population == 0 ? 4 + static_cast<int>(std::floor(3 * std::log(n))) : options.population;
  if (population_ < 4)
    throw std::invalid_argument("SeparableCmaes: population " + std::to_string(population_) +
                                ", at least 4 are needed");
  const int mu = population_ / 2;
  weights_.resize(mu);
  for (int i = 0; i < mu; ++i) weights_[i] = std::log((population_ + 1) / 2.0) - std::log(i + 1.0);
  weights_ /= weights_.sum();
  muEff_ = 1 / weights_.squaredNorm();
  cSigma_ = (muEff_ + 2) / (n + muEff_ + 5);
  dSigma_ = 1 + 2 * std::max(0.0, std::sqrt((muEff_ - 1) / (n + 1)) - 1) + cSigma_;
  cC_ = (4 + muEff_ / n) / (n + 4 + 2 * muEff_ / n);
  const double faster = (n + 2) / 3;
  c1_ = std::min(1.0, faster * 2 / ((n + 1.3) * (n + 1.3) + muEff_));
  cMu_ = std::min(1 - c1_, faster * 2 * (muEff_ - 2 + 1 / muEff_) / ((n + 2) * (n + 2) + muEff_));
  chiN_ = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  mean_ = box_.fromBox(space().start).cwiseQuotient(space().sigma);
  pathSigma_ = pathC_ = Eigen::VectorXd::Zero(dimension());
  variances_ = Eigen::VectorXd::Ones(dimension());
}

Eigen::VectorXd SeparableCmaes::favourite() const { return box_.toBox(mean_.cwiseProduct(space().sigma)); }

void SeparableCmaes::sample(Eigen::MatrixXd& candidates) {
  Random random(seed_ * 0xd1342543de82ef95ULL + static_cast<std::uint64_t>(drawn()));
  z_.resize(dimension(), population_);
  for (Eigen::Index i = 0; i < z_.size(); ++i) z_.data()[i] = random.gaussian();
  const Eigen::VectorXd scales = sigma_ * variances_.cwiseSqrt();
  candidates.resize(dimension(), population_);
  for (Eigen::Index k = 0; k < candidates.cols(); ++k)
    for (Eigen::Index i = 0; i < candidates.rows(); ++i)
      candidates(i, k) = box_.toBox(i, space().sigma[i] * (mean_[i] + scales[i] * z_(i, k)));
}

void SeparableCmaes::update(std::span<const double> costs, std::span<const int> order) {
  const Eigen::VectorXd scales = variances_.cwiseSqrt();
  Eigen::VectorXd white = Eigen::VectorXd::Zero(dimension()), squares = white;
  for (Eigen::Index i = 0; i < weights_.size(); ++i) {
    const auto z = z_.col(order[static_cast<std::size_t>(i)]);
    white += weights_[i] * z;
    squares += weights_[i] * z.cwiseAbs2();
  }
  const Eigen::VectorXd step = scales.cwiseProduct(white);
  mean_ += sigma_ * step;
  ++updates_;
  pathSigma_ = (1 - cSigma_) * pathSigma_ + std::sqrt(cSigma_ * (2 - cSigma_) * muEff_) * white;
  const double length = pathSigma_.norm();
  const double settled = std::sqrt(1 - std::pow(1 - cSigma_, 2.0 * static_cast<double>(updates_)));
  const bool pathIsShort = length / settled < (1.4 + 2 / (dimension() + 1.0)) * chiN_;
  pathC_ *= 1 - cC_;
  if (pathIsShort) pathC_ += std::sqrt(cC_ * (2 - cC_) * muEff_) * step;
  const double forgotten = (pathIsShort ? 0 : c1_ * cC_ * (2 - cC_)) - c1_ - cMu_;
  variances_ =
      (1 + forgotten) * variances_ + c1_ * pathC_.cwiseAbs2() + cMu_ * variances_.cwiseProduct(squares);
  sigma_ *= std::exp(std::min(1.0, cSigma_ / dSigma_ * (length / chiN_ - 1)));
  const double best = costs[static_cast<std::size_t>(order[0])],
               worst = costs[static_cast<std::size_t>(order[order.size() - 1])];
  // A plateau gives no direction; widen the search, as Cmaes does.
  if (best == costs[static_cast<std::size_t>(order[static_cast<std::size_t>(0.1 + population_ / 4.0)])])
    sigma_ *= std::exp(0.2 + cSigma_ / dSigma_);
  stillFor_ = std::max(worst - best, std::abs(best - bestBefore_)) < stop().tolFun ? stillFor_ + 1 : 0;
  bestBefore_ = best;
}

StopReason SeparableCmaes::converged() const {
  const double largest = sigma_ * std::sqrt(variances_.maxCoeff());
  if (!std::isfinite(largest) || largest > mostGrowth ||
      variances_.minCoeff() * worstCondition < variances_.maxCoeff())
    return StopReason::condition;
  if (stillFor_ >= 10 + 30 * dimension() / population_) return StopReason::tolFun;
  return largest < stop().tolX ? StopReason::tolX : StopReason::none;
}

MAKE_OPTIMIZER(separable,
               {"sep-cmaes", 15,
                [](const SearchSpace& space, const OptimizerOptions& given) -> std::unique_ptr<Optimizer> {
                  return std::make_unique<SeparableCmaes>(space, given);
                }});

}  // namespace plumbline
