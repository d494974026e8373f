#include "gap/inference/WindowReplayer.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "gap/replay/DoublePair.h"

namespace plumbline::gap {

namespace {

constexpr double windowSeconds = 0.2;
constexpr std::size_t mostCoefficients = 12;
constexpr double windowStep = 0.001, windowGearStep = 0.0005;  // of the replays [s], see ReplayOptions
constexpr StartShift positionShift{.position = 1e-3}, speedShift{.speed = 2e-2};

std::shared_ptr<const Groups> groupsFrom(const Groups& groups,
                                         const std::vector<std::vector<Window>>& windows,
                                         const StartShift& shift) {
  std::vector<Trial> trials;
  for (std::size_t t = 0; t < windows.size(); ++t)
    trials.push_back(restartedAt(windows[t], groups.trials()[t], shift));
  return std::make_shared<Groups>(std::move(trials));
}

std::shared_ptr<const Replayer> replayerOf(const Mechanism& robot, const Groups& groups, int jobs) {
  ReplayOptions accuracy;
  accuracy.step = windowStep;
  accuracy.gearStep = windowGearStep;
  return std::make_shared<Replayer>(robot, groups, jobs, accuracy);
}

}  // namespace

CosineBasis::CosineBasis(std::size_t length, std::size_t most)
    : length_(length), count_(std::min(length, most)) {
  for (std::size_t k = 0; k < length_; ++k)
    for (std::size_t j = 0; j < count_; ++j)
      values_.push_back(std::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(k) + 0.5) /
                                 static_cast<double>(length_)));
}

Eigen::VectorXd CosineBasis::coefficients(const ResidualSeries& residuals, std::size_t from) const {
  Eigen::VectorXd coefficients(static_cast<Eigen::Index>(count_));
  double* const sums = coefficients.data();
  const double* const values = &*(residuals.begin() + static_cast<std::ptrdiff_t>(from));
  std::size_t j = 0;
  for (; j + 7 < count_; j += 8) addUp<4>(values, j, sums);
  for (; j + 3 < count_; j += 4) addUp<2>(values, j, sums);
  for (; j + 1 < count_; j += 2) addUp<1>(values, j, sums);
  for (; j < count_; ++j) {
    double sum = 0;
    for (std::size_t k = 0; k < length_; ++k) sum += values[k] * values_[k * count_ + j];
    sums[j] = sum;
  }
  for (j = 0; j < count_; ++j) sums[j] *= std::sqrt((j == 0 ? 1.0 : 2.0) / static_cast<double>(length_));
  return coefficients;
}

/// Sums of twice as many coefficients from the first on, each in the order of the samples.
template <std::size_t pairs>
void CosineBasis::addUp(const double* values, std::size_t first, double* sums) const {
  std::array<DoublePair, pairs> of{};
  const double* row = values_.data() + first;
  for (std::size_t k = 0; k < length_; ++k, row += count_)
    for (std::size_t p = 0; p < pairs; ++p) of[p] += values[k] * readDoubles<DoublePair>(row + 2 * p);
  for (std::size_t p = 0; p < pairs; ++p) writeDoubles(sums + first + 2 * p, of[p]);
}

WindowReplayer::WindowReplayer(const Mechanism& robot, const Groups& groups, int jobs) {
  auto windows = std::make_shared<std::vector<std::vector<Window>>>();
  for (std::size_t t = 0; t < groups.trials().size(); ++t) {
    std::vector<double> noises;
    for (const ChannelUse& use : groups.uses()[t]) noises.push_back(use.noise);
    windows->push_back(windowsIn(groups.trials()[t], windowSeconds, noises));
  }
  groups_ = groupsFrom(groups, *windows, {});
  groupsMoved_ = groupsFrom(groups, *windows, positionShift);
  groupsHurried_ = groupsFrom(groups, *windows, speedShift);
  windows_ = std::move(windows);
  plain_ = replayerOf(robot, *groups_, jobs);
  moved_ = replayerOf(robot, *groupsMoved_, jobs);
  hurried_ = replayerOf(robot, *groupsHurried_, jobs);
  layOut();
  putFactors();
}

WindowReplayer::WindowReplayer(const WindowReplayer& whole, std::size_t leftOut)
    : windows_(whole.windows_),
      groups_(std::make_shared<Groups>(whole.groups_->without(leftOut))),
      groupsMoved_(std::make_shared<Groups>(whole.groupsMoved_->without(leftOut))),
      groupsHurried_(std::make_shared<Groups>(whole.groupsHurried_->without(leftOut))),
      plain_(std::make_shared<Replayer>(*whole.plain_, *groups_)),
      moved_(std::make_shared<Replayer>(*whole.moved_, *groupsMoved_)),
      hurried_(std::make_shared<Replayer>(*whole.hurried_, *groupsHurried_)) {
  layOut();
  putFactors();
}

std::size_t WindowReplayer::numAsked() const {
  return plain_->numAsked() + moved_->numAsked() + hurried_->numAsked();
}

/// Puts the windows that were measured and are predicted without gaps into cells.
void WindowReplayer::layOut() {
  const Residuals nominal = plain_->residuals({});
  std::map<std::pair<std::size_t, std::string>, std::size_t> known;
  for (const Cell& cell : groups_->cells()) {
    const Signal& signal = groups_->trials()[cell.trial].signals[cell.signal];
    // The readings of the body's sensors depend on all joints at once.
    if (signal.joint < 0) continue;
    const auto fits = [&](const Window& window) {
      if (window.from < cell.from || window.to > cell.to) return false;
      if (!std::isfinite(window.starts[static_cast<std::size_t>(signal.joint)].speed)) return false;
      const Series& residuals = nominal[cell.trial][cell.signal];
      for (std::size_t k = window.from; k < window.to; ++k)
        if (!residuals || !std::isfinite((*residuals)[k])) return false;
      return true;
    };
    const auto [at, fresh] = known.try_emplace({cell.group, signal.name}, cells_.size());
    if (fresh) cells_.push_back({cell.group, signal.joint, cell.noise, {}, 1});
    for (const Window& window : (*windows_)[cell.trial])
      if (fits(window))
        cells_[at->second].columns.push_back({cell.trial, cell.signal, window.from, window.to});
  }
  std::erase_if(cells_, [](const CoefficientCell& cell) { return cell.columns.empty(); });
}

void WindowReplayer::putFactors() {
  const Coefficients here = plainCoefficients(*plain_, {}), moved = plainCoefficients(*moved_, {}),
                     hurried = plainCoefficients(*hurried_, {});
  factors_.resize(cells_.size());
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const CoefficientCell& cell = cells_[c];
    const auto rows = here[c].rows();
    const Eigen::MatrixXd byPosition = (moved[c] - here[c]) / positionShift.position,
                          bySpeed = (hurried[c] - here[c]) / speedShift.speed;
    for (std::size_t w = 0; w < cell.columns.size(); ++w) {
      const CoefficientCell::Part& part = cell.columns[w];
      Eigen::MatrixXd covariance = cell.noise * cell.noise * Eigen::MatrixXd::Identity(rows, rows);
      for (const Window& window : (*windows_)[part.trial]) {
        if (window.from != part.from) continue;
        Eigen::MatrixXd response(rows, 2);
        response << byPosition.col(static_cast<Eigen::Index>(w)), bySpeed.col(static_cast<Eigen::Index>(w));
        covariance +=
            response * window.starts[static_cast<std::size_t>(cell.joint)].covariance * response.transpose();
      }
      factors_[c].emplace_back(covariance.llt().matrixL());
    }
  }
}

Coefficients WindowReplayer::plainCoefficients(const Replayer& replayer, const Explanation& causes) const {
  const Residuals residuals = replayer.residuals(causes);
  Coefficients result;
  std::map<std::pair<std::size_t, std::size_t>, CosineBasis> bases;  // windows have few lengths
  for (const CoefficientCell& cell : cells_) {
    std::size_t shortest = mostCoefficients;
    for (const CoefficientCell::Part& part : cell.columns) shortest = std::min(shortest, part.to - part.from);
    Eigen::MatrixXd of = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(shortest),
                                               static_cast<Eigen::Index>(cell.columns.size()));
    for (std::size_t w = 0; w < cell.columns.size(); ++w) {
      const CoefficientCell::Part& part = cell.columns[w];
      const Series& series = residuals[part.trial][part.signal];
      if (!series) continue;
      const std::size_t length = part.to - part.from;
      const CosineBasis& basis = bases.try_emplace({length, shortest}, length, shortest).first->second;
      of.col(static_cast<Eigen::Index>(w)) = basis.coefficients(*series, part.from);
    }
    result.push_back(std::move(of));
  }
  return result;
}

Coefficients WindowReplayer::coefficients(const Explanation& causes) const {
  Coefficients result = plainCoefficients(*plain_, causes);
  for (std::size_t c = 0; c < cells_.size(); ++c)
    for (std::size_t w = 0; w < cells_[c].columns.size(); ++w)
      factors_[c][w].triangularView<Eigen::Lower>().solveInPlace(result[c].col(static_cast<Eigen::Index>(w)));
  return result;
}

}  // namespace plumbline::gap
