#include "gap/diagnosis/PossibleCauses.h"

#include <algorithm>
#include <array>
#include <set>

#include "gap/replay/Ensemble.h"

namespace plumbline::gap {

namespace {

constexpr double cleanChi =
    0.35;  // mean square beyond noise, in a channel, below which a chain counts as clean
constexpr double chainShare = 0.02;  // of the worst joint's excess: chains below that wait for a later round
constexpr double jointShare = 0.08;  // of the chain's worst
constexpr double standingChi = 3, standingShare = 0.3;  // the same on the feet, of all joints' worst
constexpr std::size_t mostUnderLoad = 2;  // causes: with more found, nothing is looked for there

/// Joints that runs with a held base show to be off: themselves, and in a chain of which any is.
struct Suspects {
  std::vector<double> excess;  ///< per joint: mean square beyond noise in its worst run
  std::vector<bool> joint, chain;
  bool any = false;
};

/// The worst mean square beyond noise of each joint's positions, in runs with a held base or on the feet.
std::vector<double> excessOf(const Evaluator& evaluator, bool standing) {
  const auto& trials = evaluator.evidence().trials();
  std::vector<double> excess(evaluator.mechanism().joints.size(), 0);
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Signal& signal = trials[t].signals[s];
      if (trials[t].freeBase != standing || signal.kind != SignalKind::position) continue;
      double& most = excess[static_cast<std::size_t>(signal.joint)];
      most = std::max(most, evaluator.chi(t, s) - 1);
    }
  return excess;
}

Suspects suspectsOf(const Evaluator& evaluator) {
  const Mechanism& robot = evaluator.mechanism();
  const std::size_t n = robot.joints.size();
  Suspects result{excessOf(evaluator, false), std::vector<bool>(n), std::vector<bool>(n)};
  const double all = *std::ranges::max_element(result.excess);
  for (std::size_t j = 0; j < n; ++j) {
    double chain = 0;
    const std::vector<int> near =
        evaluator.jointsTouched({nullptr, {Site::joint, static_cast<int>(j), ""}, 0, 0});
    for (const int other : near) chain = std::max(chain, result.excess[static_cast<std::size_t>(other)]);
    result.chain[j] = chain > std::max(cleanChi, chainShare * all);
    result.joint[j] = result.chain[j] && result.excess[j] > jointShare * chain;
    result.any = result.any || result.chain[j];
  }
  if (!evaluator.hasHeld()) {
    result.chain.assign(n, true);
    result.joint.assign(n, true);
    result.any = true;
  }
  return result;
}

bool measured(const Evidence& data, SignalKind a, SignalKind b) {
  return std::ranges::any_of(data.trials(), [&](const Trial& trial) {
    return std::ranges::any_of(trial.signals, [&](const Signal& s) { return s.kind == a || s.kind == b; });
  });
}

/// Whether an effect at a joint can show elsewhere in the chain more than at the joint itself.
bool showsElsewhere(const Effect& effect) {
  return effect.id == "joint_offset" || effect.id == "encoder_nonlinearity";
}

/// Whether a cause would let a joint hunt at which the base has a cause already: the doubt that hunting
/// leaves would excuse whatever that one does not explain.
bool wouldExcuse(const Cause& cause, const Evaluator& evaluator) {
  const auto there = [&](const Cause& other) { return other.place == cause.place; };
  if (cause.place.site != Site::joint || std::ranges::none_of(evaluator.base(), there)) return false;
  return hunts(plantOf(evaluator.mechanism(), {cause}).joints[static_cast<std::size_t>(cause.place.index)]);
}

/// What a leg shows only with the robot's weight on it.
class UnderLoad {
public:
  explicit UnderLoad(const Evaluator& evaluator_) : evaluator(evaluator_) {
    if (!evaluator.hasHeld() || !evaluator.hasStanding() || evaluator.base().size() >= mostUnderLoad) return;
    if (suspectsOf(evaluator).any) return;
    excess = excessOf(evaluator, true);
    worst = *std::ranges::max_element(excess);
    for (const auto& foot : evaluator.mechanism().feet)
      for (const int joint : evaluator.mechanism().chain(foot.link)) legs.insert(joint);
  }
  bool shows(const Effect& effect, const Place& place) const {
    if (!(worst > standingChi)) return false;
    static constexpr std::array ofMotors{"torque_limit", "thermal_derating", "load_friction",
                                         "joint_compliance"};
    if (place.site == Site::link) {
      const std::vector<int> chain = evaluator.mechanism().chain(place.index);
      return !chain.empty() && legs.contains(chain.back());
    }
    if (place.site != Site::joint || !legs.contains(place.index)) return false;
    if (effect.id == "joint_offset") return true;
    return std::ranges::find(ofMotors, effect.id) != ofMotors.end() &&
           excess[static_cast<std::size_t>(place.index)] > standingShare * worst;
  }

private:
  const Evaluator& evaluator;
  std::vector<double> excess;
  double worst = 0;
  std::set<int> legs;
};

}  // namespace

bool showsUnderLoad(const Evaluator& evaluator, const Cause& cause) {
  return UnderLoad(evaluator).shows(*cause.effect, cause.place);
}

std::vector<Cause> possibleCauses(const Evaluator& evaluator) {
  const Mechanism& robot = evaluator.mechanism();
  const Suspects suspects = suspectsOf(evaluator);
  const UnderLoad underLoad(evaluator);
  const bool imu = measured(evaluator.evidence(), SignalKind::gyro, SignalKind::accelerometer);
  const bool forces = measured(evaluator.evidence(), SignalKind::force, SignalKind::force);
  const auto possible = [&](const Effect& effect, const Place& place) {
    const auto index = static_cast<std::size_t>(place.index);
    switch (place.site) {
      case Site::imu:
        return imu;
      case Site::foot:
        return forces;
      case Site::ground:
        return evaluator.hasStanding();
      case Site::everywhere:
        return suspects.any &&
               (effect.id != "speed_limit" || robot.joints[0].servo.model != Servo::Model::dcMotor);
      case Site::joint:
        if (effect.id == "speed_limit" && robot.joints[index].servo.model == Servo::Model::dcMotor)
          return false;
        return suspects.joint[index] || (suspects.chain[index] && showsElsewhere(effect));
      case Site::link: {
        const std::vector<int> chain = robot.chain(place.index);
        if (chain.empty()) return evaluator.hasStanding();
        return static_cast<bool>(suspects.chain[static_cast<std::size_t>(chain.back())]);
      }
    }
    return false;
  };
  std::vector<Cause> causes;
  for (const Effect* effect : effects())
    for (const Place& place : placesOf(*effect, robot)) {
      const auto there = [&](const Cause& cause) { return cause.effect == effect && cause.place == place; };
      if ((!possible(*effect, place) && !underLoad.shows(*effect, place)) ||
          std::ranges::any_of(evaluator.base(), there))
        continue;
      const double scale = effect->scaleAt(robot, place);
      for (int variant = 0; variant < effect->numVariants(); ++variant)
        for (const double start : effect->starts) {
          const Cause cause{effect, place, start * scale, variant};
          if (!wouldExcuse(cause, evaluator)) causes.push_back(cause);
        }
    }
  return causes;
}

}  // namespace plumbline::gap
