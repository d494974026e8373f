#include "optimization/Cmaes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "math/Median.h"
#include "math/Random.h"
#include "optimization/Optimizers.h"

namespace plumbline {
namespace {

constexpr double maxCondition = 1e14;
constexpr double stepShortening = 0.5, pathShortening = 0.25;
constexpr double growthLimit = 1e4;  // more means divergence: the cost falls without end

std::size_t historyLength(int n, int lambda) {
  return static_cast<std::size_t>(10 + std::ceil(30.0 * n / lambda));
}

/// Writes numbers into a text of bytes, or reads them back; one list of fields serves both.
struct Writer {
  std::string& bytes;
  void raw(const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }
  template <typename T>
  void number(const T& value) {
    raw(&value, sizeof value);
  }
  template <typename M>
  void matrix(const M& m) {
    raw(m.data(), sizeof(double) * static_cast<std::size_t>(m.size()));
  }
  void list(const std::deque<double>& values) {
    number(static_cast<std::uint64_t>(values.size()));
    for (const double v : values) number(v);
  }
};

struct Reader {
  const std::string& bytes;
  std::size_t at = 0;
  void raw(void* data, std::size_t size) {
    if (size > bytes.size() - at) throw std::invalid_argument("Cmaes::restore: the state is cut short");
    std::memcpy(data, bytes.data() + at, size);
    at += size;
  }
  template <typename T>
  void number(T& value) {
    raw(&value, sizeof value);
  }
  template <typename M>
  void matrix(M& m) {
    raw(m.data(), sizeof(double) * static_cast<std::size_t>(m.size()));
  }
  void list(std::deque<double>& values) {
    std::uint64_t size = 0;
    number(size);
    if (size > (bytes.size() - at) / sizeof(double))
      throw std::invalid_argument("Cmaes::restore: the state is cut short");
    values.resize(size);
    for (double& v : values) number(v);
  }
};

}  // namespace

Cmaes::Cmaes(SearchSpace given, CmaesOptions options)
    : Optimizer(std::move(given), options.stop, options.ahead),
      options_(options),
      box_(space().lower, space().upper) {
  const int n = dimension();
  const double dn = n;
  if (options_.population == 0) options_.population = 4 + static_cast<int>(std::floor(3 * std::log(dn)));
  if (options_.population < 4)
    throw std::invalid_argument("Cmaes: population " + std::to_string(options_.population) +
                                ", at least 4 are needed");
  const int lambda = options_.population;

  weights_.resize(lambda);
  for (int i = 0; i < lambda; ++i) weights_[i] = std::log((lambda + 1) / 2.0) - std::log(i + 1.0);
  mu_ = lambda / 2;
  const auto good = weights_.head(mu_);
  const auto bad = weights_.tail(lambda - mu_);
  muEff_ = good.sum() * good.sum() / good.squaredNorm();
  const double muEffBad = bad.sum() * bad.sum() / std::max(bad.squaredNorm(), 1e-300);
  cC_ = (4 + muEff_ / dn) / (dn + 4 + 2 * muEff_ / dn);
  cSigma_ = (muEff_ + 2) / (dn + muEff_ + 5);
  dSigma_ = 1 + 2 * std::max(0.0, std::sqrt((muEff_ - 1) / (dn + 1)) - 1) + cSigma_;
  c1_ = 2 / ((dn + 1.3) * (dn + 1.3) + muEff_);
  cMu_ = std::min(1 - c1_, 2 * (0.25 + muEff_ + 1 / muEff_ - 2) / ((dn + 2) * (dn + 2) + muEff_));
  chiN_ = std::sqrt(dn) * (1 - 1 / (4 * dn) + 1 / (21 * dn * dn));
  // Equation 50 to 53: what the bad candidates may take away at most.
  const double most =
      std::min({1 + c1_ / cMu_, 1 + 2 * muEffBad / (muEff_ + 2), (1 - c1_ - cMu_) / (dn * cMu_)});
  weights_.head(mu_) /= good.sum();
  weights_.tail(lambda - mu_) *= options_.active ? most / -bad.sum() : 0.0;
  decomposeEvery_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(0.5 / ((c1_ + cMu_) * dn)));

  mean_ = box_.fromBox(space().start).cwiseQuotient(space().sigma);
  pathSigma_ = pathC_ = Eigen::VectorXd::Zero(n);
  scales_ = Eigen::VectorXd::Ones(n);
  covariance_ = axes_ = Eigen::MatrixXd::Identity(n, n);
}

Eigen::VectorXd Cmaes::favourite() const { return box_.toBox(mean_.cwiseProduct(space().sigma)); }

Eigen::VectorXd Cmaes::deviations() const {
  return sigma_ * covariance_.diagonal().cwiseSqrt().cwiseProduct(space().sigma);
}

void Cmaes::sample(Eigen::MatrixXd& candidates) {
  Random random(options_.seed * 0xd1342543de82ef95ULL + static_cast<std::uint64_t>(drawn()));
  auto& [z, y, from] = drawn_.emplace_back();
  z.resize(dimension(), population());
  for (Eigen::Index i = 0; i < z.size(); ++i) z.data()[i] = random.gaussian();
  y.noalias() = axes_ * z;
  from = mean_;
  candidates.resize(dimension(), population());
  for (Eigen::Index k = 0; k < candidates.cols(); ++k)
    for (Eigen::Index i = 0; i < candidates.rows(); ++i)
      candidates(i, k) = box_.toBox(i, space().sigma[i] * (mean_[i] + sigma_ * y(i, k)));
}

void Cmaes::update(std::span<const double> costs, std::span<const int> order) {
  const Drawn from = std::move(drawn_.front());
  drawn_.pop_front();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(dimension()), white = step;
  for (int i = 0; i < mu_; ++i) {
    step += weights_[i] * from.y.col(order[static_cast<std::size_t>(i)]);
    white += weights_[i] * from.z.col(order[static_cast<std::size_t>(i)]);
  }
  if (ahead() > 1) {
    const Eigen::VectorXd gone = (mean_ - from.mean) / sigma_;
    // The axes are others than those it was drawn with: D^-1 B' step.
    white = (axes_.transpose() * (step - pathShortening * gone)).cwiseQuotient(scales_.cwiseAbs2());
    mean_ += sigma_ * (step - stepShortening * gone);
  } else {
    mean_ += sigma_ * step;
  }
  ++updates_;

  // axes = B D, so C^(-1/2) step = B white = axes D^-1 white.
  pathSigma_ = (1 - cSigma_) * pathSigma_ +
               std::sqrt(cSigma_ * (2 - cSigma_) * muEff_) * (axes_ * white.cwiseQuotient(scales_));
  const double length = pathSigma_.norm();
  const double settled = std::sqrt(1 - std::pow(1 - cSigma_, 2.0 * static_cast<double>(updates_)));
  const bool pathIsShort = length / settled < (1.4 + 2 / (dimension() + 1.0)) * chiN_;
  pathC_ *= 1 - cC_;
  if (pathIsShort) pathC_ += std::sqrt(cC_ * (2 - cC_) * muEff_) * step;

  adaptCovariance(from, order, pathIsShort);
  sigma_ *= std::exp(std::min(1.0, cSigma_ / dSigma_ * (length / chiN_ - 1)));
  // A plateau gives no direction; widen the search (the tutorial's appendix B.2).
  const auto quarter = static_cast<std::size_t>(std::ceil(0.1 + population() / 4.0));
  if (costs[static_cast<std::size_t>(order[0])] == costs[static_cast<std::size_t>(order[quarter])])
    sigma_ *= std::exp(0.2 + cSigma_ / dSigma_);
  remember(costs, order);
  if (updates_ - decomposedAt_ >= decomposeEvery_) decompose();
}

void Cmaes::adaptCovariance(const Drawn& from, std::span<const int> order, bool pathIsShort) {
  const int n = dimension(), lambda = population();
  const double forgotten = (pathIsShort ? 0 : c1_ * cC_ * (2 - cC_)) - c1_ - cMu_ * weights_.sum();
  covariance_.triangularView<Eigen::Lower>() *= 1 + forgotten;
  covariance_.selfadjointView<Eigen::Lower>().rankUpdate(pathC_, c1_);
  Eigen::MatrixXd good(n, mu_), bad(n, lambda - mu_);
  for (int i = 0; i < lambda; ++i) {
    const int k = order[static_cast<std::size_t>(i)];
    if (i < mu_) {
      good.col(i) = std::sqrt(weights_[i]) * from.y.col(k);
    } else {  // z is C^(-1/2) y up to a rotation, of the covariance that it was drawn with
      const double drawn = from.z.col(k).squaredNorm();
      const double now =
          ahead() > 1 ? (axes_.transpose() * from.y.col(k)).cwiseQuotient(scales_.cwiseAbs2()).squaredNorm()
                      : 0;
      const double size = std::max({drawn, now, 1e-300});
      bad.col(i - mu_) = std::sqrt(std::max(0.0, -weights_[i]) * n / size) * from.y.col(k);
    }
  }
  covariance_.selfadjointView<Eigen::Lower>().rankUpdate(good, cMu_);
  if (options_.active) covariance_.selfadjointView<Eigen::Lower>().rankUpdate(bad, -cMu_);
}

void Cmaes::decompose() {
  decomposedAt_ = updates_;
  covariance_.triangularView<Eigen::StrictlyUpper>() = covariance_.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance_);
  if (solver.info() != Eigen::Success || !covariance_.allFinite()) {
    degenerate_ = true;
    return;
  }
  const double largest = solver.eigenvalues().maxCoeff();
  // Rounding, and many negative updates between two decompositions, can push a value to nought or below.
  degenerate_ = solver.eigenvalues().minCoeff() * maxCondition < largest;
  scales_ = solver.eigenvalues().cwiseMax(largest / maxCondition).cwiseSqrt();
  axes_.noalias() = solver.eigenvectors() * scales_.asDiagonal();
}

void Cmaes::remember(std::span<const double> costs, std::span<const int> order) {
  const auto at = [&](std::size_t i) { return costs[static_cast<std::size_t>(order[i])]; };
  lastSpread_ = at(order.size() - 1) - at(0);
  bests_.push_back(at(0));
  medians_.push_back(at(order.size() / 2));
  const double n = dimension(), lambda = population();
  const auto longest = static_cast<std::size_t>(
      std::clamp(0.2 * static_cast<double>(updates_), 120 + 30 * n / lambda, 20000.0));
  while (bests_.size() > longest) {
    bests_.pop_front();
    medians_.pop_front();
  }
}

StopReason Cmaes::converged() const {
  if (degenerate_) return StopReason::condition;
  const bool plateau = lastSpread_ < stop().tolFun;  // there the search widens on purpose
  if ((sigma_ * scales_.maxCoeff() > growthLimit && !plateau) || !std::isfinite(sigma_))
    return StopReason::condition;
  const std::size_t length = historyLength(dimension(), population());
  if (bests_.size() >= length) {
    const auto [low, high] =
        std::minmax_element(bests_.end() - static_cast<std::ptrdiff_t>(length), bests_.end());
    if (std::max(*high - *low, lastSpread_) < stop().tolFun) return StopReason::tolFun;
  }
  const double spread = std::max(pathC_.cwiseAbs().maxCoeff(), std::sqrt(covariance_.diagonal().maxCoeff()));
  if (sigma_ * spread < stop().tolX) return StopReason::tolX;
  const auto window = static_cast<std::size_t>(120 + 30.0 * dimension() / population());
  if (static_cast<std::size_t>(updates_) > 2 * window && bests_.size() >= window) {
    const auto worse = [](const std::deque<double>& values) {
      const auto part = static_cast<std::ptrdiff_t>(values.size() * 3 / 10);
      return upperMedian({values.end() - part, values.end()}) >=
             upperMedian({values.begin(), values.begin() + part});
    };
    if (worse(bests_) && worse(medians_)) return StopReason::stagnation;
  }
  return StopReason::none;
}

template <typename Archive>
void Cmaes::visitState(Archive&& archive) {
  for (Eigen::VectorXd* v : {&mean_, &pathSigma_, &pathC_, &scales_}) archive.matrix(*v);
  archive.matrix(covariance_);
  archive.matrix(axes_);
  archive.number(sigma_);
  archive.number(updates_);
  archive.number(decomposedAt_);
  archive.number(lastSpread_);
  archive.list(bests_);
  archive.list(medians_);
  archive.number(degenerate_);
}

std::string Cmaes::save() const {
  if (!hasCheckpoint()) return Optimizer::save();
  std::string bytes;
  Writer writer{bytes};
  const std::int64_t header[] = {0x316165616d43, dimension(), population(), evaluations(), generations()};
  for (const std::int64_t number : header) writer.number(number);
  writer.number(bestCost());
  writer.matrix(best());
  writer.number(static_cast<std::int32_t>(stopReason()));
  const_cast<Cmaes*>(this)->visitState(writer);  // the writer changes nothing
  return bytes;
}

void Cmaes::restore(const std::string& state) {
  if (!hasCheckpoint()) return Optimizer::restore(state);
  Reader reader{state};
  std::int64_t header[5];
  for (std::int64_t& number : header) reader.number(number);
  if (header[0] != 0x316165616d43 || header[1] != dimension() || header[2] != population())
    throw std::invalid_argument("Cmaes::restore: the state is of another search");
  double cost = 0;
  Eigen::VectorXd where(dimension());
  std::int32_t reason = 0;
  reader.number(cost);
  reader.matrix(where);
  reader.number(reason);
  if (reason < 0 || reason > static_cast<int>(StopReason::condition))
    throw std::invalid_argument("Cmaes::restore: the state is damaged");
  visitState(reader);
  if (reader.at != state.size()) throw std::invalid_argument("Cmaes::restore: the state is too long");
  drawn_.clear();
  restoreProgress(header[3], header[4], cost, where, static_cast<StopReason>(reason));
}

MAKE_OPTIMIZER(cmaes,
               {"cmaes", 10,
                [](const SearchSpace& space, const OptimizerOptions& given) -> std::unique_ptr<Optimizer> {
                  CmaesOptions options;
                  options.population = given.population;
                  options.seed = given.seed;
                  options.stop = given.stop;
                  options.ahead = given.ahead;
                  return std::make_unique<Cmaes>(space, options);
                }});

}  // namespace plumbline
