#include "gap/inference/Score.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numeric>

#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double farthest = 1;    // step of a value when a group is left out, in the logarithm of its strength
constexpr double priorWidth = 2;  // of a value before any data, in the same

/// Values that the other groups are likeliest under, by one Newton step.
Explanation steppedWithout(const Replayer& replayer, const Fitted& fitted, std::size_t left) {
  const auto n = static_cast<Eigen::Index>(fitted.causes.size());
  Eigen::MatrixXd information = 1e-6 * Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
  for (std::size_t g = 0; g < fitted.information.size(); ++g) {
    if (g == left) continue;
    information += fitted.information[g];
    gradient += fitted.gradient[g];
  }
  Eigen::VectorXd way = information.llt().solve(gradient);
  way = way.cwiseMax(-farthest).cwiseMin(farthest);
  return withLogStrengths(replayer.mechanism(), fitted.causes, logStrengths(fitted.causes) + way);
}

/// Logarithm of how well the other groups know the values, over how well all do: half the difference of the
/// log determinants of their precisions.
double logKnownWithout(const Fitted& fitted, std::size_t left) {
  const auto n = static_cast<Eigen::Index>(fitted.causes.size());
  Eigen::MatrixXd others = Eigen::MatrixXd::Identity(n, n) / (priorWidth * priorWidth);
  for (std::size_t g = 0; g < fitted.information.size(); ++g)
    if (g != left) others += fitted.information[g];
  const auto halfLogDeterminant = [](const Eigen::MatrixXd& precision) {
    return Eigen::LLT<Eigen::MatrixXd>(precision).matrixLLT().diagonal().array().log().sum();
  };
  return halfLogDeterminant(others) - halfLogDeterminant(others + fitted.information[left]);
}

/// Shares that a set and the nominal model are compared with: the mean of the two correlation times.
Shares sharesOfGain(const Groups& groups, const Residuals& left, const Residuals& nominal) {
  Shares shares = sharesOf(groups, left);
  const Shares ofNominal = sharesOf(groups, nominal);
  for (std::size_t c = 0; c < shares.size(); ++c) {
    const Cell& cell = groups.cells()[c];
    const Series& series = left[cell.trial][cell.signal];
    double time = 1 / shares[c];
    if (series) time = timeOfScale(time, series->fitOf(cell.from, cell.to, cell.noise).scale, cell.noise);
    shares[c] = 2 / (time + 1 / ofNominal[c]);
  }
  return shares;
}

double densityOn(const Replayer& replayer, const Shares& shares, const Explanation& causes,
                 const std::vector<char>& wanted) {
  const Groups& groups = replayer.groups();
  const std::vector<double> of =
      densities(groups, replayer.residuals(causes, trialsOf(groups, wanted)), shares, wanted);
  return std::accumulate(of.begin(), of.end(), 0.0);
}

}  // namespace

double Scored::score() const { return std::accumulate(gain.begin(), gain.end(), -price); }

double priceOf(std::size_t causes, std::size_t kinds) {
  return static_cast<double>(causes) * std::log(static_cast<double>(std::max<std::size_t>(kinds, 2)));
}

Scored score(const Replayer& replayer, const Shares& shares, const Explanation& start, std::size_t kinds,
             int mostSteps, LeaveOut how, const std::vector<Explanation>& starts) {
  const Groups& groups = replayer.groups();
  Scored scored;
  scored.fitted = fit(replayer, shares, start, mostSteps);
  scored.price = priceOf(start.size(), kinds);
  for (std::size_t g = 0; g < groups.count(); ++g) {
    std::vector<char> others(groups.count(), 1);
    others[g] = 0;
    Explanation causes = scored.causes();
    if (!causes.empty() && how == LeaveOut::refit) {
      if (!starts.empty() &&
          densityOn(replayer, shares, starts[g], others) > densityOn(replayer, shares, causes, others))
        causes = starts[g];
      causes = fit(replayer, shares, causes, mostSteps, others).causes;
    } else if (!causes.empty()) {
      causes = steppedWithout(replayer, scored.fitted, g);
    }
    scored.without.push_back(std::move(causes));
  }
  scored.gain = gainsOf(replayer, scored.fitted, scored.without);
  return scored;
}

std::vector<double> gainsOf(const Replayer& replayer, const Fitted& fitted,
                            const std::vector<Explanation>& without) {
  const Groups& groups = replayer.groups();
  std::vector<double> gains(groups.count(), 0.0);
  if (fitted.causes.empty()) return gains;
  const Residuals left = replayer.residuals(fitted.causes), nominal = replayer.residuals({});
  const Shares shares = sharesOfGain(groups, left, nominal);
  const std::vector<double> with = densities(groups, left, shares), none = densities(groups, nominal, shares);
  const double all = std::accumulate(with.begin(), with.end(), 0.0);
  for (std::size_t g = 0; g < groups.count(); ++g) {
    std::vector<char> others(groups.count(), 1);
    others[g] = 0;
    const double compromise = densityOn(replayer, shares, without[g], others) - (all - with[g]);
    std::vector<char> own(groups.count(), 0);
    own[g] = 1;
    const double asOthers = densityOn(replayer, shares, without[g], own);
    gains[g] =
        std::max(with[g] - std::max(0.0, compromise), asOthers) - none[g] + logKnownWithout(fitted, g);
  }
  return gains;
}

}  // namespace plumbline::gap
