#include "optimization/Cmaes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

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

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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

Cmaes::Cmaes(SearchSpace space_, CmaesOptions options_)
    : Optimizer(std::move(space_), options_.stop, options_.ahead),
      options(options_),
      box(space().lower, space().upper) {
  const int n = dimension();
  const double dn = n;
  if (options.population == 0) options.population = 4 + static_cast<int>(std::floor(3 * std::log(dn)));
  if (options.population < 4)
    throw std::invalid_argument("Cmaes: population " + std::to_string(options.population) +
                                ", at least 4 are needed");
  const int lambda = options.population;

  weights.resize(lambda);
  for (int i = 0; i < lambda; ++i) weights[i] = std::log((lambda + 1) / 2.0) - std::log(i + 1.0);
  mu = lambda / 2;
  const auto good = weights.head(mu);
  const auto bad = weights.tail(lambda - mu);
  muEff = good.sum() * good.sum() / good.squaredNorm();
  const double muEffBad = bad.sum() * bad.sum() / std::max(bad.squaredNorm(), 1e-300);
  cC = (4 + muEff / dn) / (dn + 4 + 2 * muEff / dn);
  cSigma = (muEff + 2) / (dn + muEff + 5);
  dSigma = 1 + 2 * std::max(0.0, std::sqrt((muEff - 1) / (dn + 1)) - 1) + cSigma;
  c1 = 2 / ((dn + 1.3) * (dn + 1.3) + muEff);
  cMu = std::min(1 - c1, 2 * (0.25 + muEff + 1 / muEff - 2) / ((dn + 2) * (dn + 2) + muEff));
  chiN = std::sqrt(dn) * (1 - 1 / (4 * dn) + 1 / (21 * dn * dn));
  // Equation 50 to 53: what the bad candidates may take away at most.
  const double most = std::min({1 + c1 / cMu, 1 + 2 * muEffBad / (muEff + 2), (1 - c1 - cMu) / (dn * cMu)});
  weights.head(mu) /= good.sum();
  weights.tail(lambda - mu) *= options.active ? most / -bad.sum() : 0.0;
  decomposeEvery = std::max<std::int64_t>(1, static_cast<std::int64_t>(0.5 / ((c1 + cMu) * dn)));

  mean = box.fromBox(space().start).cwiseQuotient(space().sigma);
  pathSigma = pathC = Eigen::VectorXd::Zero(n);
  scales = Eigen::VectorXd::Ones(n);
  covariance = axes = Eigen::MatrixXd::Identity(n, n);
}

Eigen::VectorXd Cmaes::favourite() const { return box.toBox(mean.cwiseProduct(space().sigma)); }

Eigen::VectorXd Cmaes::deviations() const {
  return sigma_ * covariance.diagonal().cwiseSqrt().cwiseProduct(space().sigma);
}

void Cmaes::sample(Eigen::MatrixXd& candidates) {
  Random random(options.seed * 0xd1342543de82ef95ULL + static_cast<std::uint64_t>(drawn()));
  auto& [z, y, from] = drawn_.emplace_back();
  z.resize(dimension(), population());
  for (Eigen::Index i = 0; i < z.size(); ++i) z.data()[i] = random.gaussian();
  y.noalias() = axes * z;
  from = mean;
  candidates.resize(dimension(), population());
  for (Eigen::Index k = 0; k < candidates.cols(); ++k)
    for (Eigen::Index i = 0; i < candidates.rows(); ++i)
      candidates(i, k) = box.toBox(i, space().sigma[i] * (mean[i] + sigma_ * y(i, k)));
}

void Cmaes::update(std::span<const double> costs, std::span<const int> order) {
  const Drawn from = std::move(drawn_.front());
  drawn_.pop_front();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(dimension()), white = step;
  for (int i = 0; i < mu; ++i) {
    step += weights[i] * from.y.col(order[static_cast<std::size_t>(i)]);
    white += weights[i] * from.z.col(order[static_cast<std::size_t>(i)]);
  }
  if (ahead() > 1) {
    const Eigen::VectorXd gone = (mean - from.mean) / sigma_;
    // The axes are others than those it was drawn with: D^-1 B' step.
    white = (axes.transpose() * (step - pathShortening * gone)).cwiseQuotient(scales.cwiseAbs2());
    mean += sigma_ * (step - stepShortening * gone);
  } else {
    mean += sigma_ * step;
  }
  ++updates;

  // axes = B D, so C^(-1/2) step = B white = axes D^-1 white.
  pathSigma = (1 - cSigma) * pathSigma +
              std::sqrt(cSigma * (2 - cSigma) * muEff) * (axes * white.cwiseQuotient(scales));
  const double length = pathSigma.norm();
  const double settled = std::sqrt(1 - std::pow(1 - cSigma, 2.0 * static_cast<double>(updates)));
  const bool pathIsShort = length / settled < (1.4 + 2 / (dimension() + 1.0)) * chiN;
  pathC *= 1 - cC;
  if (pathIsShort) pathC += std::sqrt(cC * (2 - cC) * muEff) * step;

  adaptCovariance(from, order, pathIsShort);
  sigma_ *= std::exp(std::min(1.0, cSigma / dSigma * (length / chiN - 1)));
  // A plateau gives no direction; widen the search (the tutorial's appendix B.2).
  const auto quarter = static_cast<std::size_t>(std::ceil(0.1 + population() / 4.0));
  if (costs[static_cast<std::size_t>(order[0])] == costs[static_cast<std::size_t>(order[quarter])])
    sigma_ *= std::exp(0.2 + cSigma / dSigma);
  remember(costs, order);
  if (updates - decomposedAt >= decomposeEvery) decompose();
}

void Cmaes::adaptCovariance(const Drawn& from, std::span<const int> order, bool pathIsShort) {
  const int n = dimension(), lambda = population();
  const double forgotten = (pathIsShort ? 0 : c1 * cC * (2 - cC)) - c1 - cMu * weights.sum();
  covariance.triangularView<Eigen::Lower>() *= 1 + forgotten;
  covariance.selfadjointView<Eigen::Lower>().rankUpdate(pathC, c1);
  Eigen::MatrixXd good(n, mu), bad(n, lambda - mu);
  for (int i = 0; i < lambda; ++i) {
    const int k = order[static_cast<std::size_t>(i)];
    if (i < mu) {
      good.col(i) = std::sqrt(weights[i]) * from.y.col(k);
    } else {  // z is C^(-1/2) y up to a rotation, of the covariance that it was drawn with
      const double drawn = from.z.col(k).squaredNorm();
      const double now =
          ahead() > 1 ? (axes.transpose() * from.y.col(k)).cwiseQuotient(scales.cwiseAbs2()).squaredNorm()
                      : 0;
      const double size = std::max({drawn, now, 1e-300});
      bad.col(i - mu) = std::sqrt(std::max(0.0, -weights[i]) * n / size) * from.y.col(k);
    }
  }
  covariance.selfadjointView<Eigen::Lower>().rankUpdate(good, cMu);
  if (options.active) covariance.selfadjointView<Eigen::Lower>().rankUpdate(bad, -cMu);
}

void Cmaes::decompose() {
  decomposedAt = updates;
  covariance.triangularView<Eigen::StrictlyUpper>() = covariance.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  if (solver.info() != Eigen::Success || !covariance.allFinite()) {
    degenerate = true;
    return;
  }
  const double largest = solver.eigenvalues().maxCoeff();
  // Rounding, and many negative updates between two decompositions, can push a value to nought or below.
  degenerate = solver.eigenvalues().minCoeff() * maxCondition < largest;
  scales = solver.eigenvalues().cwiseMax(largest / maxCondition).cwiseSqrt();
  axes.noalias() = solver.eigenvectors() * scales.asDiagonal();
}

void Cmaes::remember(std::span<const double> costs, std::span<const int> order) {
  const auto at = [&](std::size_t i) { return costs[static_cast<std::size_t>(order[i])]; };
  lastSpread = at(order.size() - 1) - at(0);
  bests.push_back(at(0));
  medians.push_back(at(order.size() / 2));
  const double n = dimension(), lambda = population();
  const auto longest = static_cast<std::size_t>(
      std::clamp(0.2 * static_cast<double>(updates), 120 + 30 * n / lambda, 20000.0));
  while (bests.size() > longest) {
    bests.pop_front();
    medians.pop_front();
  }
}

StopReason Cmaes::converged() const {
  if (degenerate) return StopReason::condition;
  const bool plateau = lastSpread < stop().tolFun;  // there the search widens on purpose
  if ((sigma_ * scales.maxCoeff() > growthLimit && !plateau) || !std::isfinite(sigma_))
    return StopReason::condition;
  const std::size_t length = historyLength(dimension(), population());
  if (bests.size() >= length) {
    const auto [low, high] =
        std::minmax_element(bests.end() - static_cast<std::ptrdiff_t>(length), bests.end());
    if (std::max(*high - *low, lastSpread) < stop().tolFun) return StopReason::tolFun;
  }
  const double spread = std::max(pathC.cwiseAbs().maxCoeff(), std::sqrt(covariance.diagonal().maxCoeff()));
  if (sigma_ * spread < stop().tolX) return StopReason::tolX;
  const auto window = static_cast<std::size_t>(120 + 30.0 * dimension() / population());
  if (static_cast<std::size_t>(updates) > 2 * window && bests.size() >= window) {
    const auto worse = [](const std::deque<double>& values) {
      const auto part = static_cast<std::ptrdiff_t>(values.size() * 3 / 10);
      return medianOf({values.end() - part, values.end()}) >=
             medianOf({values.begin(), values.begin() + part});
    };
    if (worse(bests) && worse(medians)) return StopReason::stagnation;
  }
  return StopReason::none;
}

template <typename Archive>
void Cmaes::visitState(Archive&& archive) {
  for (Eigen::VectorXd* v : {&mean, &pathSigma, &pathC, &scales}) archive.matrix(*v);
  archive.matrix(covariance);
  archive.matrix(axes);
  archive.number(sigma_);
  archive.number(updates);
  archive.number(decomposedAt);
  archive.number(lastSpread);
  archive.list(bests);
  archive.list(medians);
  archive.number(degenerate);
}

std::string Cmaes::save() const {
  if (!savesItself()) return Optimizer::save();
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
  if (!savesItself()) return Optimizer::restore(state);
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
