#include "gap/inference/Score.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double farthest = 1;    // step of a value when a group is left out, in the logarithm of its strength
constexpr double priorWidth = 2;  // of a value before any data, in the same
const double motionSpread = std::getenv("TAU") ? std::atof(std::getenv("TAU")) : 0.1;

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

/// What the other groups say of a group's values, in logarithms of strengths: normal about theirs.
class ValuesOfGroup {
public:
  ValuesOfGroup(const Fitted& fitted, const Eigen::VectorXd& others, std::size_t group)
      : others_(others), information_(fitted.information[group]), gradient_(fitted.gradient[group]) {
    const auto n = others.size();
    const auto count = static_cast<double>(fitted.information.size());
    const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd known = unit / (priorWidth * priorWidth);
    for (std::size_t g = 0; g < fitted.information.size(); ++g)
      if (g != group) known += fitted.information[g];
    const Eigen::MatrixXd spread =
        known.llt().solve(unit) + motionSpread * motionSpread * count / std::max(1.0, count - 1) * unit;
    precision_ = spread.llt().solve(unit);
    spread_ = spread;
  }

  /// Posterior mode, by one Newton step from where the information was taken.
  Eigen::VectorXd likeliest(const Eigen::VectorXd& from) const {
    const Eigen::VectorXd way =
        (information_ + precision_).llt().solve(gradient_ + precision_ * (others_ - from));
    return from + way.cwiseMax(-farthest).cwiseMin(farthest);
  }
  /// Up to the constant that halfLogVolume() holds.
  double logDensity(const Eigen::VectorXd& x) const {
    return -(x - others_).dot(precision_ * (x - others_)) / 2;
  }
  /// Half the log determinant of the posterior's precision over the prior's.
  double halfLogVolume() const {
    const auto halfLog = [](const Eigen::MatrixXd& of) {
      return Eigen::LLT<Eigen::MatrixXd>(of).matrixLLT().diagonal().array().log().sum();
    };
    return halfLog(information_ + precision_) - halfLog(precision_);
  }

private:
  Eigen::VectorXd others_;
  Eigen::MatrixXd information_, precision_, spread_;
  Eigen::VectorXd gradient_;
};

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
  const std::vector<double> none = densities(groups, nominal, shares);
  const Eigen::VectorXd all = logStrengths(fitted.causes);
  for (std::size_t g = 0; g < groups.count(); ++g) {
    std::vector<char> wanted(groups.count(), 0);
    wanted[g] = 1;
    const Eigen::VectorXd others = logStrengths(without[g]);
    const ValuesOfGroup prior(fitted, others, g);
    double best = -HUGE_VAL;
    for (const Eigen::VectorXd& x : {others, all, prior.likeliest(all)}) {
      const Explanation causes = withLogStrengths(replayer.mechanism(), fitted.causes, x);
      best = std::max(best, densityOn(replayer, shares, causes, wanted) + prior.logDensity(x));
    }
    gains[g] = best - prior.halfLogVolume() - none[g];
  }
  return gains;
}

}  // namespace plumbline::gap
