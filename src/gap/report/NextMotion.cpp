#include "gap/report/NextMotion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>

#include "gap/record/ExcitationFile.h"
#include "gap/record/SimulatedRecording.h"
#include "gap/replay/Replay.h"
#include "gap/replay/TrialOf.h"
#include "gap/report/MotionDesigns.h"
#include "math/Random.h"

namespace plumbline::gap {

namespace {

/// A prediction as one long list, channel after channel, in units of noise.
std::vector<double> weighted(const Trial& trial, const Prediction& prediction) {
  std::vector<double> list;
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    const double noise = noiseOf(trial.signals[s]);
    for (const double value : prediction.values[s]) list.push_back(std::isfinite(value) ? value / noise : 0);
  }
  return list;
}

std::vector<double> played(const Mechanism& robot, const Trial& trial, const Explanation& causes,
                           const std::vector<int>& joints) {
  const Plant plant = plantOf(robot, causes);
  ReplayOptions options;
  options.joints = joints;
  std::vector<std::uint8_t> lost;
  if (plant.dropout > 0) {
    Random random(1);
    for (std::size_t k = 0; k < trial.cycles(); ++k) lost.push_back(random.uniform() < plant.dropout);
    options.lostCycles = &lost;
  }
  const Prediction prediction = replay(plant, trial, options);
  return prediction.fell ? std::vector<double>() : weighted(trial, prediction);
}

/// Length of what of a no multiple of b explains, and the other way round: the smaller.
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  const double ab = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  const double aa = std::inner_product(a.begin(), a.end(), a.begin(), 0.0);
  const double bb = std::inner_product(b.begin(), b.end(), b.begin(), 0.0);
  // An effect that cannot be turned round does not explain the opposite.
  const double shared = std::max(0.0, ab);
  const double left = bb > 0 ? aa - shared * shared / bb : aa,
               right = aa > 0 ? bb - shared * shared / aa : bb;
  return std::sqrt(std::max(0.0, std::min(left, right)));
}

double separationOf(const Mechanism& robot, const Excitation& program,
                    const std::vector<Explanation>& explanations, const std::vector<int>& joints,
                    bool fromFirst) {
  const Trial trial = trialOf(blankRun(robot, program, robot.controlHz), robot);
  // What all explanations share is no matter of doubt: it is there in the reference, too.
  Explanation shared;
  for (const Cause& cause : explanations.front())
    if (std::ranges::all_of(explanations, [&](const Explanation& e) {
          return std::ranges::any_of(
              e, [&](const Cause& c) { return c.sameKind(cause) && c.value == cause.value; });
        }))
      shared.push_back(cause);
  const std::vector<double> reference = played(robot, trial, shared, joints);
  if (reference.empty()) return 0;
  std::vector<std::vector<double>> changes;
  for (const Explanation& explanation : explanations) {
    changes.push_back(played(robot, trial, explanation, joints));
    if (changes.back().empty()) return 0;
    for (std::size_t i = 0; i < reference.size(); ++i) changes.back()[i] -= reference[i];
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < (fromFirst ? 1 : changes.size()); ++a)
    for (std::size_t b = a + 1; b < changes.size(); ++b)
      least = std::min(least, apart(changes[a], changes[b]));
  return least / std::sqrt(static_cast<double>(trial.cycles()));
}

bool isBodys(const Place& place) {
  return place.site == Site::ground || place.site == Site::foot || place.site == Site::imu;
}

}  // namespace

std::vector<int> jointsShowing(const Mechanism& robot, const Place& place) {
  std::vector<int> joints;
  if (place.site == Site::joint)
    joints = robot.chain(robot.joints[static_cast<std::size_t>(place.index)].child);
  if (place.site == Site::link) joints = robot.chain(place.index);
  if (joints.empty()) {
    joints.resize(robot.joints.size());
    std::iota(joints.begin(), joints.end(), 0);
  }
  return joints;
}

std::vector<Explanation> suspectsAt(const Mechanism& robot, int joint) {
  std::vector<Explanation> suspects;
  const std::string& name = robot.joints[static_cast<std::size_t>(joint)].name;
  std::vector<const Effect*> list = effects();
  std::erase_if(list, [](const Effect* effect) { return effect->suspect == 0 || !sitsAtJoints(*effect); });
  std::ranges::stable_sort(list, {}, &Effect::suspect);
  for (const Effect* effect : list) {
    Cause cause{effect, findPlace(*effect, robot, name, ""), 0, 0};
    cause.value = effect->starts[effect->starts.size() / 2] * effect->scaleAt(robot, cause.place);
    suspects.push_back({cause});
  }
  return suspects;
}

NextMotion findNextMotion(const Mechanism& robot, const std::vector<Explanation>& explanations,
                          NextMotionOptions options) {
  if (explanations.size() < 2) throw std::invalid_argument("there must be two explanations to separate");
  std::set<int> shown;
  bool body = options.floatingBase;
  for (const Explanation& explanation : explanations)
    for (const Cause& cause : explanation) {
      if (isBodys(cause.place)) {
        body = true;
        continue;
      }
      for (const int joint : jointsShowing(robot, cause.place)) shown.insert(joint);
    }
  if (shown.empty())
    for (int j = 0; j < robot.numJoints(); ++j) shown.insert(j);
  if (options.joints.empty()) {
    // A joint's effect shows best at the joint itself; a link's at all that carry it.
    std::set<int> moved;
    for (const Explanation& explanation : explanations)
      for (const Cause& cause : explanation)
        if (cause.place.site == Site::joint)
          moved.insert(cause.place.index);
        else if (!isBodys(cause.place))
          for (const int joint : jointsShowing(robot, cause.place)) moved.insert(joint);
    options.joints.assign(moved.empty() ? shown.begin() : moved.begin(),
                          moved.empty() ? shown.end() : moved.end());
  }
  std::vector<int> replayed(shown.begin(), shown.end());

  std::vector<Excitation> programs = motionDesigns(robot, options.joints);
  const auto take = [&](const std::vector<std::string>& names) {
    for (const std::string& name : names) try {
        programs.push_back(findExcitation(name, robot));
      } catch (const std::exception&) {
        // Not every robot can play every program, and a folder elsewhere has none.
      }
  };
  take(hangingBattery());
  if (body && !robot.feet.empty()) take(floatingBaseBattery());
  NextMotion result;
  std::size_t best = 0, done = 0;
  std::vector<MotionScore> scores;
  for (const Excitation& program : programs) {
    scores.push_back({program.name, separationOf(robot, program, explanations, replayed, options.fromFirst)});
    if (scores.back().separation > scores[best].separation) best = scores.size() - 1;
    if (options.progress)
      options.progress(static_cast<double>(++done) / static_cast<double>(programs.size()));
  }
  result.program = programs[best];
  result.best = scores[best];
  scores.erase(scores.begin() + static_cast<std::ptrdiff_t>(best));
  result.others = std::move(scores);
  std::ranges::stable_sort(result.others, std::ranges::greater(), &MotionScore::separation);
  return result;
}

std::string nextMotion(const Mechanism& robot, const Cause& a, const Cause& b) {
  const NextMotion next = findNextMotion(robot, {{a}, {b}});
  char figure[32];
  std::snprintf(figure, sizeof figure, "%.2g", next.best.separation);
  const std::size_t colon = next.program.about.find(": ");
  const std::string what =
      colon == std::string::npos ? next.program.about : next.program.about.substr(colon + 2);
  const std::string pair = std::string(a.effect->id) + " at " + a.place.at + " and " +
                           std::string(b.effect->id) + " at " + b.place.at;
  if (next.best.separation < 0.1)
    return "No motion known here separates " + pair + ": the best, " + what + ", does so by " + figure +
           " times the noise. A sensor behind the gear or a load of known mass would.";
  return "Record " + what + " (bin/gap next writes it as a program): there " + pair + " differ by " + figure +
         " times the noise.";
}

}  // namespace plumbline::gap
