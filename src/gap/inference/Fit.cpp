#include "gap/inference/Fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "gap/inference/CellInformation.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double farthest = 1;    // step of a value, in the logarithm of its strength
constexpr double settled = 0.05;  // gain of log density below which a fit ends

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Derivatives of all groups at the present values.
void linearise(const Replayer& replayer, const Shares& shares, const std::vector<char>& wantedGroups,
               const Residuals& at, Fitted& fitted) {
  const Groups& groups = replayer.groups();
  const auto n = static_cast<Eigen::Index>(fitted.causes.size());
  fitted.information.assign(groups.count(), Eigen::MatrixXd::Zero(n, n));
  fitted.gradient.assign(groups.count(), Eigen::VectorXd::Zero(n));
  for (const CellInformation& of : informationOf(replayer, shares, fitted.causes, at, wantedGroups)) {
    const std::size_t group = groups.cells()[of.cell].group;
    fitted.information[group] += of.about + of.mean;
    fitted.gradient[group] += of.gradient;
  }
}

}  // namespace

Fitted fit(const Replayer& replayer, const Shares& shares, const Explanation& start, int mostSteps,
           const std::vector<char>& wantedGroups) {
  const Groups& groups = replayer.groups();
  const std::vector<char> trials = trialsOf(groups, wantedGroups);
  Fitted fitted;
  fitted.causes = withLogStrengths(replayer.mechanism(), start, logStrengths(start));
  Residuals here = replayer.residuals(fitted.causes, trials);
  fitted.density = sumOf(densities(groups, here, shares, wantedGroups));
  const auto n = static_cast<Eigen::Index>(fitted.causes.size());
  linearise(replayer, shares, wantedGroups, here, fitted);
  double damping = 1e-2;
  for (int step = 0; n > 0 && step < mostSteps; ++step) {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
    for (std::size_t g = 0; g < groups.count(); ++g) {
      information += fitted.information[g];
      gradient += fitted.gradient[g];
    }
    const Eigen::VectorXd x = logStrengths(fitted.causes);
    bool better = false;
    double gained = 0;
    for (int attempt = 0; attempt < 4 && !better; ++attempt, damping *= 8) {
      Eigen::MatrixXd damped = information;
      // What nothing depends on stays.
      damped.diagonal() += damping * information.diagonal() + Eigen::VectorXd::Constant(n, 1e-6);
      Eigen::VectorXd way = damped.llt().solve(gradient);
      // Each for itself: a strength that hardly matters must not hold up the others.
      way = way.cwiseMax(-farthest).cwiseMin(farthest);
      Explanation next = withLogStrengths(replayer.mechanism(), fitted.causes, x + way);
      if (next == fitted.causes) break;
      Residuals there = replayer.residuals(next, trials);
      const double density = sumOf(densities(groups, there, shares, wantedGroups));
      if (density <= fitted.density) continue;
      gained = density - fitted.density;
      fitted.causes = std::move(next);
      fitted.density = density;
      here = std::move(there);
      better = true;
    }
    if (!better) break;
    damping = std::max(1e-6, damping / 40);
    linearise(replayer, shares, wantedGroups, here, fitted);
    if (gained < settled) break;
  }
  return fitted;
}

}  // namespace plumbline::gap
