#include "gap/inference/Score.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numeric>

#include "gap/inference/SettingMask.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double farthest = 1;  // step of a value when a group is left out, in the logarithm of its strength

/// The likeliest values for these groups, by one Newton step from the values for all. Where a joint sticks
/// and slips, derivatives may mislead: a step to where these groups are less likely is halved, at
/// most twice, and else not taken.
Explanation stepTowards(const Replayer& replayer, const Shares& shares, const Fitted& fitted,
                        const std::vector<char>& groups) {
  const auto n = static_cast<Eigen::Index>(fitted.causes.size());
  Eigen::MatrixXd information = 1e-6 * Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
  for (std::size_t g = 0; g < fitted.information.size(); ++g) {
    if (!groups[g]) continue;
    information += fitted.information[g];
    gradient += fitted.gradient[g];
  }
  Eigen::VectorXd way = information.llt().solve(gradient);
  way = way.cwiseMax(-farthest).cwiseMin(farthest);
  const double here = densityOn(replayer, shares, fitted.causes, groups);
  const Eigen::VectorXd x = logStrengths(fitted.causes);
  for (const double part : {1.0, 0.5, 0.25}) {
    Explanation stepped = withLogStrengths(replayer.mechanism(), fitted.causes, x + part * way);
    if (densityOn(replayer, shares, stepped, groups) >= here) return stepped;
  }
  return fitted.causes;
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
  scored.price = priceOf(start.size(), kinds) + priceOfMasks(start, recordingsOf(groups));
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
      causes = stepTowards(replayer, shares, scored.fitted, others);
    }
    scored.without.push_back(std::move(causes));
  }
  scored.gain = gainsOf(replayer, scored.causes(), scored.without);
  return scored;
}

Shares sharesOfBoth(const Groups& groups, const Residuals& left, const Residuals& nominal) {
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

std::vector<double> gainsOf(const Replayer& replayer, const Explanation& fitted,
                            const std::vector<Explanation>& without) {
  const Groups& groups = replayer.groups();
  std::vector<double> gains(groups.count(), 0.0);
  if (fitted.empty()) return gains;
  const Residuals nominal = replayer.residuals({});
  const Shares shares = sharesOfBoth(groups, replayer.residuals(fitted), nominal);
  const std::vector<double> none = densities(groups, nominal, shares);
  for (std::size_t g = 0; g < groups.count(); ++g) {
    std::vector<char> wanted(groups.count(), 0);
    wanted[g] = 1;
    gains[g] = densityOn(replayer, shares, without[g], wanted) - none[g];
  }
  return gains;
}

}  // namespace plumbline::gap
