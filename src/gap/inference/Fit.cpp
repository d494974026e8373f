#include "gap/inference/Fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "gap/inference/CellInformation.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double farthest = 1;         // step of a value, in the logarithm of its strength
constexpr double firstDamping = 1e-2;  // of a step: share of the information that is added to it
constexpr double minGain = 0.05;       // gain of log density below which derivatives lead nowhere
/// Strides of a sweep, in the logarithm of a strength: 2, 1.26 and 1.08 times.
constexpr std::array sweepStrides = {0.7, 0.233, 0.078};

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Climbs to the likeliest strengths.
class DensityClimb {
public:
  DensityClimb(const Replayer& replayer, const Shares& shares, const Explanation& start,
               const std::vector<char>& wanted)
      : replayer_(replayer), shares_(shares), wanted_(wanted), trials_(trialsOf(replayer.groups(), wanted)) {
    fitted_.causes = withLogStrengths(replayer_.mechanism(), start, logStrengths(start));
    here_ = replayer_.residuals(fitted_.causes, trials_);
    fitted_.density = densityOf(here_);
  }

  Fitted run(int mostSteps) {
    if (mostSteps > 0) sweep(1);
    for (int step = 0; step < mostSteps && !fitted_.causes.empty(); ++step) {
      const double before = fitted_.density;
      linearise();
      stepByDerivatives();
      if (fitted_.density - before >= minGain) continue;
      if (!sweep(sweepStrides.size())) break;
      damping_ = firstDamping;  // failed steps said nothing of the place that the sweep led to
    }
    linearise();
    return std::move(fitted_);
  }

private:
  double densityOf(const Residuals& residuals) const {
    return sumOf(densities(replayer_.groups(), residuals, shares_, wanted_));
  }

  /// Takes other strengths if they are likelier.
  bool moved(const Eigen::VectorXd& x) {
    Explanation next = withLogStrengths(replayer_.mechanism(), fitted_.causes, x);
    if (next == fitted_.causes) return false;
    Residuals there = replayer_.residuals(next, trials_);
    const double density = densityOf(there);
    if (density <= fitted_.density) return false;
    fitted_.causes = std::move(next);
    fitted_.density = density;
    here_ = std::move(there);
    linearised_ = false;
    return true;
  }

  /// Computes the missing derivatives of all groups at the present values.
  void linearise() {
    if (linearised_) return;
    linearised_ = true;
    const Groups& groups = replayer_.groups();
    const auto n = static_cast<Eigen::Index>(fitted_.causes.size());
    fitted_.information.assign(groups.count(), Eigen::MatrixXd::Zero(n, n));
    fitted_.gradient.assign(groups.count(), Eigen::VectorXd::Zero(n));
    for (const CellInformation& of : informationOf(replayer_, shares_, fitted_.causes, here_, wanted_)) {
      const std::size_t group = groups.cells()[of.cell].group;
      fitted_.information[group] += of.about + of.mean;
      fitted_.gradient[group] += of.gradient;
    }
  }

  /// A damped Gauss-Newton step.
  void stepByDerivatives() {
    const auto n = static_cast<Eigen::Index>(fitted_.causes.size());
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
    for (std::size_t g = 0; g < replayer_.groups().count(); ++g) {
      information += fitted_.information[g];
      gradient += fitted_.gradient[g];
    }
    const Eigen::VectorXd x = logStrengths(fitted_.causes);
    for (int attempt = 0; attempt < 4; ++attempt, damping_ *= 8) {
      Eigen::MatrixXd damped = information;
      // A value that nothing depends on stays.
      damped.diagonal() += damping_ * information.diagonal() + Eigen::VectorXd::Constant(n, 1e-6);
      Eigen::VectorXd way = damped.llt().solve(gradient);
      // Tested one by one: a strength that hardly matters must not stop the others.
      way = way.cwiseMax(-farthest).cwiseMin(farthest);
      if (!moved(x + way)) continue;
      damping_ = std::max(1e-6, damping_ / 5);
      return;
    }
  }

  /// Where a joint sticks and slips, or a motor falls short from a moment on, the density is rough and
  /// derivatives do not show where it rises. So strengths of such causes are tried on both sides, closer each
  /// time, until one is likelier.
  bool sweep(std::size_t strides) {
    for (const double way : std::span(sweepStrides).first(strides))
      for (std::size_t i = 0; i < fitted_.causes.size(); ++i)
        if (fitted_.causes[i].effect->isRough() && (stride(i, way) || stride(i, -way))) return true;
    return false;
  }

  /// Moves one strength in strides, as long as each is likelier.
  bool stride(std::size_t i, double way) {
    const double before = fitted_.density;
    Eigen::VectorXd x = logStrengths(fitted_.causes);
    do x[static_cast<Eigen::Index>(i)] += way;
    while (moved(x));
    return fitted_.density - before >= minGain;
  }

  const Replayer& replayer_;
  const Shares& shares_;
  const std::vector<char>& wanted_;
  const std::vector<char> trials_;
  Fitted fitted_;
  Residuals here_;           ///< of the present values
  bool linearised_ = false;  ///< the derivatives are those of the present values
  double damping_ = firstDamping;
};

}  // namespace

Fitted fit(const Replayer& replayer, const Shares& shares, const Explanation& start, int mostSteps,
           const std::vector<char>& wantedGroups) {
  return DensityClimb(replayer, shares, start, wantedGroups).run(mostSteps);
}

}  // namespace plumbline::gap
