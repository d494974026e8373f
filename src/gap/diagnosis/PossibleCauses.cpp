#include "gap/diagnosis/PossibleCauses.h"

#include <algorithm>

namespace plumbline::gap {

namespace {

constexpr double cleanChi =
    0.35;  // mean square beyond noise, in a channel, below which a chain counts as clean
constexpr double nearlyCleanChi = 0.8;  // the same, where runs on the feet show more
constexpr double chainShare = 0.02;  // of the worst joint's excess: chains below that wait for a later round
constexpr double jointShare = 0.08;  // of the chain's worst

/// Joints that runs show to be off: themselves, and in a chain of which any is.
struct Suspects {
  std::vector<double> excess;  ///< per joint: mean square beyond noise in its worst run
  std::vector<bool> joint, chain;
  bool any = false;
};

/// By the runs with a held base, or by those on the feet.
Suspects suspectsOf(const Evaluator& evaluator, bool standing, double clean = cleanChi) {
  const Mechanism& robot = evaluator.mechanism();
  const auto& trials = evaluator.evidence().trials();
  const std::size_t n = robot.joints.size();
  Suspects result{std::vector<double>(n, 0), std::vector<bool>(n), std::vector<bool>(n)};
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Signal& signal = trials[t].signals[s];
      if (trials[t].freeBase != standing || signal.kind != SignalKind::position) continue;
      double& most = result.excess[static_cast<std::size_t>(signal.joint)];
      most = std::max(most, evaluator.chi(t, s) - 1);
    }
  const double all = *std::ranges::max_element(result.excess);
  for (std::size_t j = 0; j < n; ++j) {
    double chain = 0;
    const std::vector<int> near =
        evaluator.jointsTouched({nullptr, {Site::joint, static_cast<int>(j), ""}, 0, 0});
    for (const int other : near) chain = std::max(chain, result.excess[static_cast<std::size_t>(other)]);
    result.chain[j] = chain > std::max(clean, chainShare * all);
    result.joint[j] = result.chain[j] && result.excess[j] > jointShare * chain;
    result.any = result.any || result.chain[j];
  }
  return result;
}

/// A held base shows a joint's faults best. Where it shows none, the load on the feet may: a leg's length, a
/// motor that is too weak. Without a held base nobody is beyond suspicion.
class Suspicion {
public:
  Suspicion(const Evaluator& evaluator, bool lookUnderLoad)
      : held(suspectsOf(evaluator, false)), underLoad(held) {
    if (!evaluator.hasHeld()) {
      for (Suspects* all : {&held, &underLoad}) {
        all->chain.assign(all->chain.size(), true);
        all->joint.assign(all->joint.size(), true);
        all->any = true;
      }
    } else if (lookUnderLoad && !evaluator.heldTells()) {
      held = suspectsOf(evaluator, false, nearlyCleanChi);
      const Suspects standing = suspectsOf(evaluator, true);
      for (std::size_t j = 0; j < held.joint.size(); ++j) {
        underLoad.joint[j] = held.joint[j] || standing.joint[j];
        underLoad.chain[j] = held.chain[j] || standing.chain[j];
      }
      underLoad.any = held.any || standing.any;
    }
  }
  const Suspects& by(const Effect& effect) const { return effect.underLoad ? underLoad : held; }

private:
  Suspects held, underLoad;
};

bool measured(const Evidence& data, SignalKind a, SignalKind b) {
  return std::ranges::any_of(data.trials(), [&](const Trial& trial) {
    return std::ranges::any_of(trial.signals, [&](const Signal& s) { return s.kind == a || s.kind == b; });
  });
}

/// Whether an effect at a joint can show elsewhere in the chain more than at the joint itself.
bool showsElsewhere(const Effect& effect) {
  return effect.id == "joint_offset" || effect.id == "encoder_nonlinearity";
}

}  // namespace

std::vector<Cause> possibleCauses(const Evaluator& evaluator, bool underLoad) {
  const Mechanism& robot = evaluator.mechanism();
  const Suspicion suspicion(evaluator, underLoad);
  const bool imu = measured(evaluator.evidence(), SignalKind::gyro, SignalKind::accelerometer);
  const bool forces = measured(evaluator.evidence(), SignalKind::force, SignalKind::force);
  const auto possible = [&](const Effect& effect, const Place& place) {
    const auto index = static_cast<std::size_t>(place.index);
    const Suspects& suspects = suspicion.by(effect);
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
      if (!possible(*effect, place) || std::ranges::any_of(evaluator.base(), there)) continue;
      const double scale = effect->scaleAt(robot, place);
      for (int variant = 0; variant < effect->numVariants(); ++variant)
        for (const double start : effect->starts) causes.push_back({effect, place, start * scale, variant});
    }
  return causes;
}

}  // namespace plumbline::gap
