#include "gap/replay/Ensemble.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr double reach = 0.25;  // [s]: over which the variance is smoothed, to each side

constexpr double invisiblePlay = 5e-4;  // [rad]: a third of a twelve-bit encoder's count
constexpr double widePlay = 0.1;        // [rad]: what swings free in it bounces, even if the motor holds

// A residual with 1 / roughnessFactor of the limit cycle's roughness, or more, may be one.
constexpr double roughnessFactor = 2;
// Mean square of a residual over the variance within `reach`: the variance counts in full up to the first
// ratio, and not at all from the second on.
constexpr double fullVarianceRatio = 4, noVarianceRatio = 8;

/// One of the replays whose variance says how uncertain the prediction of a limit cycle is.
struct Member {
  double later;  ///< the run begins so much later: another phase of the limit cycle [s]
  double toothStiffness, toothDamping;
};
constexpr std::array ensemble = {Member{0, 4000, 0.6}, Member{0.0137, 2200, 1.1}, Member{0.0291, 7000, 0.35}};

/// Mean of what is smoothed over `reach` cycles to each side.
std::vector<double> smoothed(const std::vector<double>& values, std::size_t cycles) {
  std::vector<double> sums(values.size() + 1, 0), result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) sums[k + 1] = sums[k] + values[k];
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t from = k > cycles ? k - cycles : 0, to = std::min(values.size(), k + cycles + 1);
    result[k] = (sums[to] - sums[from]) / static_cast<double>(to - from);
  }
  return result;
}

/// How much of a series is change from cycle to cycle: 0 for a slow one, 2 for white noise, 4 for one that
/// turns over each time.
class Roughness {
public:
  void add(double value) {
    if (!std::isfinite(value)) {
      last_ = value;
      return;
    }
    if (std::isfinite(last_)) changes_ += (value - last_) * (value - last_);
    squares_ += value * value;
    last_ = value;
  }
  void pause() { last_ = std::nan(""); }
  double value() const { return squares_ > 0 ? changes_ / squares_ : 0; }

private:
  double last_ = std::nan(""), changes_ = 0, squares_ = 0;
};

/// The share of a residual that may be a limit cycle: none of one that is much slower than the differences of
/// the ensemble.
double likeLimitCycle(const std::vector<double>& measured, const std::vector<double>& mean,
                      double roughness) {
  Roughness residual;
  for (std::size_t k = 0; k < mean.size(); ++k) residual.add(measured[k] - mean[k]);
  return roughness > 0 ? std::min(1.0, roughnessFactor * residual.value() / roughness) : 1;
}

/// Mean square of the second differences: what is quick in a series, whatever its level and its slow motion
/// (Roughness, a share, is for series around 0).
double quickness(const std::vector<double>& values) {
  double squares = 0, n = 0;
  for (std::size_t k = 0; k + 2 < values.size(); ++k) {
    const double second = values[k] - 2 * values[k + 1] + values[k + 2];
    if (std::isfinite(second)) squares += second * second, ++n;
  }
  return n > 0 ? squares / n : 0;
}

/// Whether the measurement has the predicted limit cycle at all, 0 to 1: it then moves about as quickly as
/// the prediction. Of 16 joints of hung NAOs in MuJoCo, those with a limit cycle had a sixth of the predicted
/// squares or more; those that deviated for another reason had a twentieth at most. calm: the prediction
/// without backlash.
double alsoCycles(const std::vector<double>& measured, const std::vector<double>& calm, double cycling) {
  constexpr double noCycleShare = 0.05, fullCycleShare = 0.1;
  const double quick = quickness(calm), more = cycling - quick;
  return more > 0 ? std::clamp(((quickness(measured) - quick) / more - noCycleShare) /
                                   (fullCycleShare - noCycleShare),
                               0.0, 1.0)
                  : 1;
}

/// Takes back the doubt where the ensemble agrees far better with itself than with what was measured: that
/// is no limit cycle.
void keepWhereBorneOut(std::vector<double>& variance, const std::vector<double>& measured,
                       const std::vector<double>& mean, std::size_t cycles) {
  std::vector<double> squares(mean.size());
  for (std::size_t k = 0; k < mean.size(); ++k) {
    const double r = measured[k] - mean[k];
    squares[k] = std::isfinite(r) ? r * r : 0;
  }
  squares = smoothed(squares, cycles);
  for (std::size_t k = 0; k < mean.size(); ++k)
    if (squares[k] > fullVarianceRatio * variance[k])
      variance[k] *=
          std::max(0.0, (noVarianceRatio - squares[k] / variance[k]) / (noVarianceRatio - fullVarianceRatio));
}

/// Mean and smoothed variance of one signal over the members. The variance is that of one more member, which
/// is not among them, around their mean.
void combine(const std::vector<Prediction>& all, const Prediction& calm, const Trial& trial,
             std::size_t signal, std::size_t cycles, Prediction& result) {
  const double n = static_cast<double>(all.size());
  std::vector<double>& mean = result.values[signal];
  std::vector<double> variance(mean.size(), 0);
  for (std::size_t k = 0; k < mean.size(); ++k) {
    double sum = 0, squares = 0;
    for (const Prediction& one : all) sum += one.values[signal][k];
    mean[k] = sum / n;
    for (const Prediction& one : all) squares += std::pow(one.values[signal][k] - mean[k], 2);
    variance[k] = std::isfinite(mean[k]) ? squares / (n - 1) * (1 + 1 / n) : 0;
  }
  Roughness differences;
  for (const Prediction& one : all) {
    for (std::size_t k = 0; k < mean.size(); ++k) differences.add(one.values[signal][k] - mean[k]);
    differences.pause();
  }
  const std::vector<double>& measured = trial.signals[signal].values;
  double cycling = 0;
  for (const Prediction& one : all) cycling += quickness(one.values[signal]) / n;
  const double share = likeLimitCycle(measured, mean, differences.value()) *
                       alsoCycles(measured, calm.values[signal], cycling);
  for (double& v : variance) v *= share * share;
  result.variance[signal] = smoothed(variance, cycles);
  keepWhereBorneOut(result.variance[signal], measured, mean, cycles);
}

}  // namespace

bool hasLimitCycle(const JointPlant& joint) {
  return joint.backlash > (joint.linkEncoder ? invisiblePlay : widePlay);
}

bool anyLimitCycle(const Plant& plant) { return std::ranges::any_of(plant.joints, hasLimitCycle); }

Prediction predictEnsemble(const Plant& plant, const Trial& trial, const ReplayOptions& options) {
  bool any = false;
  for (std::size_t j = 0; j < plant.joints.size(); ++j)
    any = any || (hasLimitCycle(plant.joints[j]) &&
                  (options.joints.empty() ||
                   std::ranges::find(options.joints, static_cast<int>(j)) != options.joints.end()));
  if (!any) return replay(plant, trial, options);
  std::vector<Prediction> all;
  for (const Member& member : ensemble) {
    Plant other = plant;
    for (JointPlant& joint : other.joints) {
      joint.toothStiffness = member.toothStiffness;
      joint.toothDamping = member.toothDamping;
    }
    ReplayOptions later = options;
    later.settle += member.later;
    all.push_back(replay(other, trial, later));
  }
  Plant still = plant;
  for (JointPlant& joint : still.joints)
    if (hasLimitCycle(joint)) joint.backlash = 0;
  const Prediction calm = replay(still, trial, options);
  const double cycle =
      trial.cycles() > 1 ? (trial.time.back() - trial.time.front()) / static_cast<double>(trial.cycles() - 1)
                         : reach;
  const auto cycles = static_cast<std::size_t>(std::clamp(std::round(reach / cycle), 1.0, 1000.0));
  Prediction result = all.front();
  result.variance.resize(result.values.size());
  for (std::size_t s = 0; s < result.values.size(); ++s)
    if (!result.values[s].empty()) combine(all, calm, trial, s, cycles, result);
  return result;
}

}  // namespace plumbline::gap
