#include "gap/diagnosis/DeviatingJoints.h"

#include <algorithm>
#include <set>

namespace plumbline::gap {

namespace {

constexpr double cleanChi =
    0.35;  // mean square beyond noise, in a channel, below which a chain counts as clean
constexpr double chainShare = 0.02;  // of the worst joint's excess: chains below that wait for a later round
constexpr double jointShare = 0.08;  // of the chain's worst, or of the robot's where it steps

constexpr double apart = 10;  // times its own noise that a joint's repeats differ by

// Lost commands move most chains away at once, by more than this mean square over noise.
constexpr double mostShare = 0.75, chainOff = 1.5;
constexpr std::size_t fewChains = 3;  // a robot with fewer is judged by its joints

/// Joints whose repeats differ by far more than their noise: a deviation can hide in that.
std::vector<bool> restlessJoints(const Evaluator& evaluator) {
  std::vector<bool> restless(evaluator.mechanism().joints.size(), false);
  const Evidence& data = evaluator.evidence();
  for (std::size_t t = 0; t < data.trials().size(); ++t)
    for (std::size_t s = 0; s < data.trials()[t].signals.size(); ++s) {
      const Signal& signal = data.trials()[t].signals[s];
      if (data.trials()[t].freeBase || signal.kind != SignalKind::position) continue;
      const SignalNoise& noise = data.noise(t, s);
      if (noise.sigma > apart * noise.own) restless[static_cast<std::size_t>(signal.joint)] = true;
    }
  return restless;
}

/// Joints without a position in some run with a fixed base: a fault there shows in their neighbours.
std::vector<bool> unseenJoints(const Evaluator& evaluator) {
  std::vector<bool> unseen(evaluator.mechanism().joints.size(), false);
  for (const Trial& trial : evaluator.evidence().trials()) {
    if (trial.freeBase) continue;
    std::vector<bool> seen(unseen.size(), false);
    for (const Signal& signal : trial.signals)
      if (signal.kind == SignalKind::position) seen[static_cast<std::size_t>(signal.joint)] = true;
    for (std::size_t j = 0; j < unseen.size(); ++j) unseen[j] = unseen[j] || !seen[j];
  }
  return unseen;
}

/// The largest of the joints that one motor drives: a fault of the motor shows in any of them.
std::vector<double> motorExcess(const Mechanism& robot, std::vector<double> excess) {
  for (std::size_t j = 0; j < excess.size(); ++j) {
    double& most = excess[static_cast<std::size_t>(robot.motorOf(static_cast<int>(j)))];
    most = std::max(most, excess[j]);
  }
  return excess;
}

/// Whether in every run the robot steps: its joints then restart at their measured angles.
bool allStep(const Evidence& data) {
  return std::ranges::none_of(data.trials(), [](const Trial& trial) { return trial.restarts.empty(); });
}

}  // namespace

std::vector<double> jointExcess(const Evaluator& evaluator, bool floatingBase) {
  std::vector<double> excess(evaluator.mechanism().joints.size(), 0);
  evaluator.forEachChannel([&](const Trial& trial, const Signal& signal, double chi) {
    if (trial.freeBase != floatingBase || signal.kind != SignalKind::position) return;
    double& most = excess[static_cast<std::size_t>(signal.joint)];
    most = std::max(most, chi - 1);
  });
  return excess;
}

DeviatingJoints::DeviatingJoints(const Evaluator& evaluator) {
  const std::size_t n = evaluator.mechanism().joints.size();
  if (!evaluator.hasFixedBase()) {
    chain.assign(n, true);
    joint.assign(n, true);
    weak.assign(n, true);
    any = true;
    if (allStep(evaluator.evidence())) onlyDeviating(evaluator);
    return;
  }
  chain.resize(n);
  joint.resize(n);
  weak.resize(n);
  const std::vector<double> excess = motorExcess(evaluator.mechanism(), jointExcess(evaluator, false));
  const double all = *std::ranges::max_element(excess);
  const std::vector<bool> restless = restlessJoints(evaluator), unseen = unseenJoints(evaluator);
  for (std::size_t j = 0; j < n; ++j) {
    double worst = 0;
    const std::vector<int> near =
        evaluator.jointsTouched({nullptr, {Site::joint, static_cast<int>(j), ""}, 0, 0});
    for (const int other : near) worst = std::max(worst, excess[static_cast<std::size_t>(other)]);
    chain[j] = worst > std::max(cleanChi, chainShare * all);
    joint[j] = chain[j] && (excess[j] > jointShare * worst || restless[j] || unseen[j]);
    weak[j] = chain[j] && excess[j] > cleanChi;
    any = any || chain[j];
  }
}

/// A fault in a joint's drive shows most at that joint, even if the ground passes it on to the others.
void DeviatingJoints::onlyDeviating(const Evaluator& evaluator) {
  const std::vector<double> excess = motorExcess(evaluator.mechanism(), jointExcess(evaluator, true));
  const double all = *std::ranges::max_element(excess);
  for (std::size_t j = 0; j < excess.size(); ++j) {
    weak[j] = excess[j] > cleanChi;
    joint[j] = weak[j] && excess[j] > jointShare * all;
  }
}

bool mostDeviates(const Evaluator& evaluator) {
  std::set<int> roots, rootsOff, joints, jointsOff;
  evaluator.forEachChannel([&](const Trial& trial, const Signal& signal, double chi) {
    if (trial.freeBase || signal.kind != SignalKind::position) return;
    const int root = evaluator.jointsTouched({nullptr, {Site::joint, signal.joint, ""}, 0, 0}).front();
    roots.insert(root);
    joints.insert(signal.joint);
    if (!(chi > chainOff)) return;
    rootsOff.insert(root);
    jointsOff.insert(signal.joint);
  });
  const bool few = roots.size() < fewChains;
  const auto &all = few ? joints : roots, &off = few ? jointsOff : rootsOff;
  return !off.empty() && static_cast<double>(off.size()) >= mostShare * static_cast<double>(all.size());
}

}  // namespace plumbline::gap
