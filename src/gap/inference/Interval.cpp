#include "gap/inference/Interval.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "gap/inference/CellInformation.h"
#include "gap/inference/Likelihood.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double deviations = 1.96;        // to each side of a normal value, that 95 % lie within
constexpr double mostDeviation = 2;        // of a value, in the logarithm of its strength
constexpr double correlationSpread = 0.3;  // of a channel's discrepancy with what a cause changes there

/// Of the i-th value over what leaving each group out makes of it.
double jackknifeVariance(const Scored& scored, Eigen::Index i) {
  const auto groups = static_cast<double>(scored.without.size());
  if (groups < 2) return 0;
  double mean = 0, squares = 0;
  for (const Explanation& without : scored.without) mean += logStrengths(without)[i] / groups;
  for (const Explanation& without : scored.without) squares += std::pow(logStrengths(without)[i] - mean, 2);
  return (groups - 1) / groups * squares;
}

/// How far the value moves, per unit of correlation, if all of a cell's discrepancy is along what it reads
/// off the cell. way: its row of the covariance.
double pullOf(const StretchFit& stretch, double share, const CellInformation& of,
              const Eigen::VectorXd& way) {
  const double known = stretch.noise / stretch.scale;
  const double discrepancy = std::max(0.0, 1 - known * known);  // share of the variance
  return std::sqrt(discrepancy * stretch.samples * share * std::max(0.0, way.dot(of.about * way)));
}

/// Profile of the log density near the fit: one value is fixed, the others are fitted.
class Profile {
public:
  Profile(const Replayer& replayer, const Explanation& causes, const Shares& shares)
      : replayer_(replayer),
        causes_(causes),
        shares_(shares),
        x_(logStrengths(causes)),
        atFit_(density(x_)) {}

  /// How far the i-th value goes along `way`, which has it at +1 or -1, until the log density has fallen by
  /// what a 95 % interval takes (Wilks), at most `most`. first: where to look first. A density need not be
  /// curved where it is fitted: a reading once a cycle is the same for all delays within the cycle.
  double reach(const Eigen::VectorXd& way, double first, double most) const {
    double inside = 0, outside = most;
    double next = std::clamp(first, minFirstLook, most);
    for (int look = 0; look < mostLooks && outside > endRatio * inside; ++look) {
      (atFit_ - density(x_ + next * way) < fall ? inside : outside) = next;
      if (inside >= most) break;
      next = outside < most ? (inside > 0 ? std::sqrt(inside * outside) : outside / 4)
                            : std::min(most, 3 * inside);
    }
    return inside > 0 ? std::sqrt(inside * outside) : outside;
  }

private:
  static constexpr double fall = deviations * deviations / 2;
  static constexpr double minFirstLook = 1e-4;  // in the logarithm of a strength
  static constexpr double endRatio = 1.2;       // of what is outside to what is inside: near enough
  static constexpr int mostLooks = 10;          // each replays everything

  double density(const Eigen::VectorXd& x) const {
    return densityOn(replayer_, shares_, withLogStrengths(replayer_.mechanism(), causes_, x));
  }

  const Replayer& replayer_;
  const Explanation& causes_;
  const Shares& shares_;
  Eigen::VectorXd x_;
  double atFit_;
};

}  // namespace

std::vector<Bounds> intervalsOf(const Replayer& replayer, const Scored& scored) {
  const Groups& groups = replayer.groups();
  const Explanation& causes = scored.causes();
  const auto n = static_cast<Eigen::Index>(causes.size());
  if (n == 0) return {};
  const Residuals left = replayer.residuals(causes);
  const Shares shares = sharesOf(groups, left);
  const std::vector<CellInformation> cells = informationOf(replayer, shares, causes, left);
  Eigen::MatrixXd information = 1e-6 * Eigen::MatrixXd::Identity(n, n);
  for (const CellInformation& of : cells) information += of.about + of.mean;
  const Eigen::MatrixXd covariance = information.llt().solve(Eigen::MatrixXd::Identity(n, n));
  const Profile profile(replayer, causes, shares);
  std::vector<Bounds> intervals;
  for (Eigen::Index i = 0; i < n; ++i) {
    std::map<std::string, double> pulls;  // per channel
    for (const CellInformation& of : cells) {
      const Cell& cell = groups.cells()[of.cell];
      const StretchFit stretch = left[cell.trial][cell.signal]->fitOf(cell.from, cell.to, cell.noise);
      pulls[groups.trials()[cell.trial].signals[cell.signal].name] +=
          pullOf(stretch, shares[of.cell], of, covariance.col(i));
    }
    double bias = 0;
    for (const auto& [channel, pull] : pulls) bias += std::pow(correlationSpread * pull, 2);
    const double deviation = std::sqrt(covariance(i, i)), jackknife = jackknifeVariance(scored, i);
    const Eigen::VectorXd way = covariance.col(i) / covariance(i, i);
    const auto endAt = [&](double side) {
      const double reach = profile.reach(side * way, deviations * deviation, deviations * mostDeviation);
      // The bias is scaled with the variance of the profile, because the curvature at an edge is not it.
      const double scale = std::pow(reach / (deviations * deviation), 2);
      const double half = std::sqrt(std::max(reach * reach, deviations * deviations * jackknife) +
                                    std::pow(deviations * scale, 2) * bias);
      Eigen::VectorXd x = logStrengths(causes);
      x[i] += side * std::min(half, deviations * mostDeviation);
      return withLogStrengths(replayer.mechanism(), causes, x)[static_cast<std::size_t>(i)].value;
    };
    const double one = endAt(1), other = endAt(-1);
    intervals.push_back({std::min(one, other), std::max(one, other)});
  }
  return intervals;
}

}  // namespace plumbline::gap
