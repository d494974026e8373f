#include "training/WalkTraining.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <stdexcept>

#include "framework/ConfigOverlay.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "framework/Parallel.h"
#include "optimization/Optimizers.h"
#include "training/GroupedLines.h"

namespace plumbline::walking {
namespace {

constexpr const char* recoveryName = "recovery";

struct Step {
  const char* name;
  double step;
};

constexpr Step shape[] = {
    {"posture.hipHeight", 0.006},
    {"posture.feetDistance", 0.006},
    {"posture.torsoPitch", 0.04},
    {"speed.trimForward", 0.02},
    {"step.duration", 0.008},
    {"step.maxForward", 0.02},
    {"step.maxBackward", 0.02},
    {"step.maxOutward", 0.02},
    {"step.height", 0.006},
    {"step.swingStart", 0.06},
    {"step.swingEnd", 0.06},
    {"step.swingSmoothness", 0.15},
    {"step.swingSteepness", 0.2},
    {"step.swingPitch", 0.06},
    {"model.pendulumHeight", 0.03},
    {"model.lateralHeightOffset", 0.03},
    {"model.copForward", 0.006},
    {"model.copOutward", 0.006},
    {"arms.swing", 1.5},
};
constexpr Step feedback[] = {
    {"feedback.delay", 0.01},          {"feedback.ankleRollGain", 0.1},    {"feedback.anklePitchGain", 0.1},
    {"feedback.ankleRollRate", 0.01},  {"feedback.anklePitchRate", 0.01},  {"feedback.hipRollGain", 0.1},
    {"feedback.hipPitchGain", 0.1},    {"feedback.hipRollRate", 0.01},     {"feedback.hipPitchRate", 0.01},
    {"feedback.stepForwardGain", 0.1}, {"feedback.stepSidewaysGain", 0.1}, {"feedback.swingLevel", 0.2},
    {"feedback.comForwardGain", 0.1},  {"feedback.comSidewaysGain", 0.1},
};

constexpr Step recovery[] = {
    {"observation.positionGain", 0.2},
    {"observation.velocityGain", 0.2},
    {"observation.velocityGainLateral", 0.3},
    {"observation.positionGainLateral", 0.3},
    {"feedback.swingMeasuredPitch", 0.3},
    {"feedback.swingMeasuredRoll", 0.3},
    {"feedback.torsoMeasured", 0.2},
    {"step.maxForward", 0.03},
    {"step.maxBackward", 0.03},
    {"step.maxOutward", 0.03},
    {"posture.feetDistance", 0.01},
    {"step.height", 0.006},
    {"model.pendulumHeight", 0.03},
    {"model.lateralHeightOffset", 0.03},
    {"model.copForward", 0.01},
    {"feedback.stepForwardGain", 0.2},
    {"feedback.stepSidewaysGain", 0.2},
    {"feedback.swingLevel", 0.3},
    {"feedback.anklePitchGain", 0.15},
    {"feedback.ankleRollGain", 0.15},
    {"feedback.anklePitchRate", 0.015},
    {"feedback.ankleRollRate", 0.015},
    {"feedback.hipPitchGain", 0.15},
    {"feedback.hipRollGain", 0.15},
};

/// Robots to try walks on, as many as are needed at a time. A try begins with everything reset, so that it
/// does not matter on which of them it is made.
class WalkerPool {
public:
  WalkerPool(const TrainingSetup& setup, const WalkGaits& gaits) : setup_(setup), gaits_(gaits) {}

  TrialResult tryOn(const WalkGaits& walk, const TrialSetup& trial) {
    std::unique_ptr<Walker> robot = take();
    const TrialResult result = tryWalk(*robot, walk, setup_.task, trial);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(robot));
    return result;
  }

private:
  std::unique_ptr<Walker> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return setup_.walker(gaits_);
    std::unique_ptr<Walker> robot = std::move(idle_.back());
    idle_.pop_back();
    return robot;
  }

  const TrainingSetup& setup_;
  const WalkGaits& gaits_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Walker>> idle_;
};

WalkParameters& sectionOf(WalkGaits& gaits, const std::string& name) {
  for (std::size_t i = 0; i < WalkGaits::numCorners; ++i)
    if (name == WalkGaits::cornerNames[i]) return gaits.corner[i];
  return gaits.base;
}

}  // namespace

void checkWalkParameters(const std::vector<std::string>& paths) {
  std::vector<std::string> known;
  for (const WalkParameter& one : walkParameters()) known.push_back(one.path);
  for (const std::string& path : paths)
    if (!findWalkParameter(path))
      throw ConfigurationError("no walking parameter \"" + path + "\"" + suggestion(path, known));
}

std::vector<Variable> variablesOf(Task task) {
  std::vector<Variable> variables;
  const auto add = [&](const std::string& section, const char* name, double step) {
    variables.push_back({section, &walkParameter(name), step});
  };
  if (task == Task::mixture) {
    for (const Step& s : feedback) add("", s.name, s.step / 2);
    add("", "speed.maxForward", 0.05);
    add("", "speed.maxBackward", 0.05);
    add("", "speed.maxSideways", 0.05);
    add("", "speed.maxTurn", 0.15);
    add("", "speed.accelerationForward", 0.15);
    add("", "speed.decelerationForward", 0.15);
    add("", "speed.accelerationSideways", 0.1);
    add("", "speed.accelerationTurn", 1);
    add("", "feedback.tiltTolerance", 0.05);
    add("", "feedback.tiltBrake", 1);
    add("", "startStop.duration", 0.01);
    return variables;
  }
  if (task == Task::push) {
    for (const Step& s : recovery) add(recoveryName, s.name, s.step);
    // Not when it begins to recover: with nothing but pushes that would be always.
    add("", "recovery.fadeTime", 0.2);
    add("", "recovery.captureMargin", 0.015);
    return variables;
  }
  const std::string corner = taskNames[static_cast<std::size_t>(task)];
  for (const Step& s : shape) add(corner, s.name, s.step);
  for (const Step& s : feedback) add(corner, s.name, s.step);
  switch (task) {
    case Task::forward:
      add("", "speed.maxForward", 0.15);
      add(corner, "speed.brakeLead", 0.03);
      break;
    case Task::backward:
      add("", "speed.maxBackward", 0.15);
      add(corner, "speed.brakeLead", 0.03);
      break;
    case Task::sideways:
      add("", "speed.maxSideways", 0.1);
      add(corner, "speed.accelerationSideways", 0.1);
      break;
    case Task::turn:
      add("", "speed.maxTurn", 0.4);
      break;
    case Task::mixture:
    case Task::push:
      break;
  }
  return variables;
}

double valueOf(const WalkGaits& gaits, const Variable& variable) {
  if (variable.section == recoveryName) return variable.parameter->of(gaits.at(Vec2::Zero(), 0, 1));
  WalkGaits copy = gaits;
  return variable.parameter->of(sectionOf(copy, variable.section));
}

void setValue(WalkGaits& gaits, const Variable& variable, double value) {
  const WalkParameter& parameter = *variable.parameter;
  const double allowed = std::clamp(value, parameter.declared->range.min, parameter.declared->range.max);
  if (variable.section == recoveryName) {
    parameter.of(gaits.recovery) = allowed;
    return;
  }
  WalkParameters& section = sectionOf(gaits, variable.section);
  if (&section == &gaits.base)
    gaits.setBase(parameter, allowed);
  else
    parameter.of(section) = allowed;
  if (parameter.path == "step.duration") {
    section.step.minDuration = std::max(0.04, 0.88 * section.step.duration);
    section.step.maxDuration = std::max(0.08, 1.16 * section.step.duration);
  }
}

double cost(Task task, const TrialResult& r) {
  switch (task) {
    case Task::forward:
      return -r.speed + 0.15 * r.drift + 1.5 * r.falls;
    case Task::backward:
    case Task::sideways:
      return -r.speed + 0.3 * r.drift + 1.5 * r.falls;
    case Task::turn:
      return -r.speed / 2.5 + 0.5 * r.drift + 1.5 * r.falls;
    case Task::mixture:
      return -r.speed + 0.3 * r.falls;
    case Task::push:
      return r.falls;
  }
  return 0;
}

WalkGaits train(const WalkGaits& gaits, const TrainingSetup& setup,
                const std::function<void(const std::string&, const WalkGaits&)>& progress) {
  checkWalkParameters(setup.only);
  std::vector<Variable> variables = variablesOf(setup.task);
  if (!setup.only.empty())
    std::erase_if(variables, [&](const Variable& v) {
      return std::find(setup.only.begin(), setup.only.end(), v.parameter->path) == setup.only.end();
    });
  if (variables.empty()) throw std::invalid_argument("this task searches none of the named parameters");
  const auto n = static_cast<Eigen::Index>(variables.size());
  SearchSpace space = SearchSpace::around(Eigen::VectorXd::Zero(n), setup.sigma);
  space.lower.resize(n);
  space.upper.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Variable& v = variables[static_cast<std::size_t>(i)];
    const double start = valueOf(gaits, v);
    // A value on its bound may still move a little.
    space.lower[i] = std::min(-0.1, (v.parameter->declared->range.min - start) / v.step);
    space.upper[i] = std::max(0.1, (v.parameter->declared->range.max - start) / v.step);
  }
  const auto decode = [&](const Eigen::VectorXd& x) {
    WalkGaits decoded = gaits;
    for (std::size_t i = 0; i < variables.size(); ++i)
      setValue(decoded, variables[i],
               valueOf(gaits, variables[i]) + variables[i].step * x[static_cast<Eigen::Index>(i)]);
    return decoded;
  };
  OptimizerOptions options;
  options.population = setup.population;
  options.seed = setup.seed;
  options.stop.maxGenerations = setup.generations;
  const std::unique_ptr<Optimizer> optimizer = makeOptimizer(setup.optimizer, space, options);
  Optimizer& search = *optimizer;
  if (!setup.state.empty()) search.restore(setup.state);
  WalkerPool pool(setup, gaits);
  const char* task = taskNames[static_cast<std::size_t>(setup.task)];
  char line[200];
  while (!search.isDone()) {
    const Eigen::MatrixXd candidates = search.ask();
    TrialSetup trial = setup.trial;
    trial.seed = setup.seed * 100000 + static_cast<std::uint64_t>(search.generations());
    const auto count = static_cast<std::size_t>(candidates.cols());
    std::vector<double> costs(count);
    std::atomic<int> tried = 0;
    parallel(count, setup.jobs, [&](std::size_t i) {
      const WalkGaits candidate = decode(candidates.col(static_cast<Eigen::Index>(i)));
      costs[i] = cost(setup.task, pool.tryOn(candidate, trial));
      if (setup.report)
        setup.report(std::string(task) + ", " + setup.robot,
                     (static_cast<double>(search.generations()) + ++tried / static_cast<double>(count)) /
                         setup.generations);
    });
    search.tell(costs);
    if (search.generations() % 10 == 0) {
      const WalkGaits favourite = decode(search.favourite());
      const TrialResult r = pool.tryOn(favourite, trial);
      std::snprintf(line, sizeof line,
                    "%s, %s, generation %d: speed %.3f, falls %.2f, drift %.3f, sigma %.3f", task,
                    setup.robot.c_str(), static_cast<int>(search.generations()), r.speed, r.falls, r.drift,
                    search.sigma());
      progress(line, favourite);
    }
    if (setup.store) setup.store(search.save());
  }
  TrialSetup last = setup.trial;
  last.seed = setup.seed * 100000 + 99999;
  last.tries *= 8;
  last.stopEarly = false;
  WalkGaits found = decode(search.favourite());
  if (setup.report) setup.report("comparing what was found, " + std::string(task), -1);
  TrialResult before, after;
  parallel(2, setup.jobs,
           [&](std::size_t i) { (i == 0 ? before : after) = pool.tryOn(i == 0 ? gaits : found, last); });
  if (!(cost(setup.task, after) < cost(setup.task, before))) found = gaits;
  std::snprintf(line, sizeof line,
                "%s, %s: speed %.3f, falls %.3f, drift %.3f -> speed %.3f, falls %.3f, drift %.3f", task,
                setup.robot.c_str(), before.speed, before.falls, before.drift, after.speed, after.falls,
                after.drift);
  progress(line, found);
  return found;
}

WalkGaits withCornersOf(const WalkGaits& gaits, const WalkGaits& other) {
  WalkGaits result = gaits;
  result.corner = other.corner;
  for (WalkParameters& corner : result.corner)
    corner.posture.hipHeight += gaits.base.posture.hipHeight - other.base.posture.hipHeight;
  SpeedParameters& speed = result.base.speed;
  speed.maxForward = other.base.speed.maxForward;
  speed.maxBackward = other.base.speed.maxBackward;
  speed.maxSideways = other.base.speed.maxSideways;
  speed.maxTurn = other.base.speed.maxTurn;
  return result;
}

std::string walkFile(const WalkGaits& gaits, const WalkParameters& common, const std::string& heading) {
  using training::GroupedLines;
  GroupedLines base("");
  for (const WalkParameter& one : walkParameters())
    if (one.of(gaits.base) != one.of(common)) base.add(one.path, one.of(gaits.base));
  std::string others;
  std::size_t count = base.count;
  const auto addGait = [&](const char* name, const WalkParameters& gait) {
    const bool isRecovery = &gait == &gaits.recovery;
    GroupedLines lines("    ");
    for (const WalkParameter& one : walkParameters()) {
      const double value = one.of(gait);
      const bool same = isRecovery ? std::isnan(value) : value == one.of(gaits.base);
      if (one.blends && !same) lines.add(one.path, value);
    }
    if (lines.count > 0) others += std::string("  ") + name + ":\n" + lines.text;
    count += lines.count;
  };
  for (std::size_t i = 0; i < WalkGaits::numCorners; ++i) addGait(WalkGaits::cornerNames[i], gaits.corner[i]);
  addGait(recoveryName, gaits.recovery);
  return "# " + heading + "\n" + overlayLine("walking.yaml", count) + "\n" + base.text +
         (others.empty() ? "" : "gaits:\n" + others);
}

}  // namespace plumbline::walking
