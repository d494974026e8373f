#include "gap/inference/Fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "gap/inference/Likelihood.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double difference = 0.02;  // step of derivatives, in the logarithm of a strength
constexpr double farthest = 1;       // step of a value, in the same
constexpr double settled = 0.05;     // gain of log density below which a fit ends

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Each cause a step away in turn, and how far that is.
struct Moved {
  std::vector<Residuals> residuals;
  std::vector<double> steps;
};

Moved movedFrom(const Replayer& replayer, const Explanation& causes, const std::vector<char>& trials) {
  const Eigen::VectorXd x = logStrengths(causes);
  Moved moved;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    // Away from a bound, if one is near.
    double step = difference;
    Explanation other;
    for (int attempt = 0; attempt < 2; ++attempt, step = -step) {
      Eigen::VectorXd y = x;
      y[i] += step;
      other = withLogStrengths(replayer.mechanism(), causes, y);
      if (other[at].value != causes[at].value) break;
    }
    moved.steps.push_back(logStrengths(other)[i] - x[i]);
    moved.residuals.push_back(replayer.residuals(other, trials));
  }
  return moved;
}

/// Of one cell, whose residuals are `here`; none where no cause changes anything.
std::optional<CellInformation> informationIn(const Cell& cell, double share, const Series& here,
                                             const Residuals& at, const Moved& moved) {
  const auto n = static_cast<Eigen::Index>(moved.steps.size());
  // Causes that change nothing here have no say.
  std::vector<Eigen::Index> felt;
  for (Eigen::Index i = 0; i < n; ++i)
    if (const auto j = static_cast<std::size_t>(i);
        moved.steps[j] != 0 && moved.residuals[j][cell.trial][cell.signal] != here)
      felt.push_back(i);
  if (felt.empty()) return std::nullopt;
  const Split parts = split(residualsOf(cell, at));
  const StretchFit stretch = here->fitOf(cell.from, cell.to, cell.noise);
  const auto samples = static_cast<Eigen::Index>(parts.about.size()),
             width = static_cast<Eigen::Index>(felt.size());
  // Derivatives of the residuals, a column per sample, and of their mean.
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(width, samples);
  double count = 0;
  for (Eigen::Index k = 0; k < samples; ++k) {
    const std::size_t cycle = cell.from + static_cast<std::size_t>(k);
    const double r = (*here)[cycle];
    if (!std::isfinite(r)) continue;
    for (Eigen::Index i = 0; i < width; ++i) {
      const auto j = static_cast<std::size_t>(felt[static_cast<std::size_t>(i)]);
      slopes(i, k) = ((*moved.residuals[j][cell.trial][cell.signal])[cycle] - r) / moved.steps[j];
    }
    ++count;
  }
  if (count == 0) return std::nullopt;
  const Eigen::VectorXd meanSlope = slopes.rowwise().sum() / count;
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(width), about(width);
  Eigen::MatrixXd varying = Eigen::MatrixXd::Zero(width, width);
  for (Eigen::Index k = 0; k < samples; ++k)
    if (const double r = parts.about[static_cast<std::size_t>(k)]; std::isfinite(r)) {
      about = slopes.col(k) - meanSlope;
      const double w = share * weightOf(r, stretch.scale);
      gradient -= w * r * about;
      varying += w * about * about.transpose();
    }
  const double w = weightOf(parts.mean, stretch.meanScale(share));
  gradient -= w * parts.mean * meanSlope;
  CellInformation of{0, Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  of.about(felt, felt) = varying;
  of.mean(felt, felt) = w * meanSlope * meanSlope.transpose();
  of.gradient(felt) = gradient;
  return of;
}

/// Derivatives of all groups at the present values.
void linearise(const Replayer& replayer, const Shares& shares, const std::vector<char>& wantedGroups,
               Fitted& fitted) {
  const Groups& groups = replayer.groups();
  const auto n = static_cast<Eigen::Index>(fitted.causes.size());
  fitted.information.assign(groups.count(), Eigen::MatrixXd::Zero(n, n));
  fitted.gradient.assign(groups.count(), Eigen::VectorXd::Zero(n));
  for (const CellInformation& of : informationOf(replayer, shares, fitted.causes, wantedGroups)) {
    const std::size_t group = groups.cells()[of.cell].group;
    fitted.information[group] += of.about + of.mean;
    fitted.gradient[group] += of.gradient;
  }
}

}  // namespace

std::vector<CellInformation> informationOf(const Replayer& replayer, const Shares& shares,
                                           const Explanation& causes, const std::vector<char>& wantedGroups) {
  const Groups& groups = replayer.groups();
  const std::vector<char> trials = trialsOf(groups, wantedGroups);
  const Residuals at = replayer.residuals(causes, trials);
  const Moved moved = movedFrom(replayer, causes, trials);
  std::vector<CellInformation> all;
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const Cell& cell = groups.cells()[c];
    if (!wantedGroups.empty() && !wantedGroups[cell.group]) continue;
    const Series& here = at[cell.trial][cell.signal];
    if (!here) continue;
    if (auto of = informationIn(cell, shares[c], here, at, moved)) {
      of->cell = c;
      all.push_back(std::move(*of));
    }
  }
  return all;
}

Fitted fit(const Replayer& replayer, const Shares& shares, const Explanation& start, int mostSteps,
           const std::vector<char>& wantedGroups) {
  const Groups& groups = replayer.groups();
  const std::vector<char> trials = trialsOf(groups, wantedGroups);
  Fitted fitted;
  fitted.causes = withLogStrengths(replayer.mechanism(), start, logStrengths(start));
  Residuals here = replayer.residuals(fitted.causes, trials);
  fitted.density = sumOf(densities(groups, here, shares, wantedGroups));
  const auto n = static_cast<Eigen::Index>(fitted.causes.size());
  linearise(replayer, shares, wantedGroups, fitted);
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
    linearise(replayer, shares, wantedGroups, fitted);
    if (gained < settled) break;
  }
  return fitted;
}

}  // namespace plumbline::gap
