#include "gap/inference/CellInformation.h"

#include <cmath>
#include <optional>

#include "gap/inference/Likelihood.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double difference = 0.02;  // step of derivatives, in the logarithm of a strength

/// Moves each cause by a step in turn, with the size of the step.
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

/// Of the c-th cell; none where it was not predicted or no cause changes anything.
std::optional<CellInformation> informationIn(const Groups& groups, std::size_t c, double share,
                                             const Residuals& at, const Moved& moved) {
  const Cell& cell = groups.cells()[c];
  const Series& here = at[cell.trial][cell.signal];
  if (!here) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(moved.steps.size());
  // Causes that change nothing here do not count.
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
  CellInformation of{c, Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  of.about(felt, felt) = varying;
  of.mean(felt, felt) = w * meanSlope * meanSlope.transpose();
  of.gradient(felt) = gradient;
  return of;
}

}  // namespace

std::vector<CellInformation> informationOf(const Replayer& replayer, const Shares& shares,
                                           const Explanation& causes, const Residuals& at,
                                           const std::vector<char>& wantedGroups) {
  const Groups& groups = replayer.groups();
  const Moved moved = movedFrom(replayer, causes, trialsOf(groups, wantedGroups));
  std::vector<CellInformation> all;
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    if (!wantedGroups.empty() && !wantedGroups[groups.cells()[c].group]) continue;
    if (auto of = informationIn(groups, c, shares[c], at, moved)) all.push_back(std::move(*of));
  }
  return all;
}

}  // namespace plumbline::gap
