#include "training/WalkTraining.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <stdexcept>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigOverlay.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "framework/Parallel.h"
#include "optimization/Optimizers.h"
#include "training/FirstSteps.h"
#include "training/GroupedLines.h"

namespace plumbline::training {
namespace {

constexpr const char* recoveryName = "recovery";

/// Robots to try walks on, as many as are needed at a time. A try begins with everything reset, so that it
/// does not matter on which of them it is made.
class WalkerPool {
public:
  WalkerPool(const WalkTrainingSetup& setup, const walking::WalkGaits& gaits)
      : setup_(setup), gaits_(gaits) {}

  WalkTrialResult tryOn(const walking::WalkGaits& walk, const WalkTrialSetup& trial) {
    std::unique_ptr<Walker> robot = take();
    const WalkTrialResult result = tryWalk(*robot, walk, setup_.task, trial);
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

  const WalkTrainingSetup& setup_;
  const walking::WalkGaits& gaits_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Walker>> idle_;
};

std::vector<std::string> pathsOfWalk() {
  std::vector<std::string> paths;
  for (const walking::WalkParameter& one : walking::walkParameters()) paths.push_back(one.path);
  return paths;
}

walking::WalkParameters& sectionOf(walking::WalkGaits& gaits, const std::string& name) {
  for (std::size_t i = 0; i < walking::WalkGaits::numCorners; ++i)
    if (name == walking::WalkGaits::cornerNames[i]) return gaits.corner[i];
  return gaits.base;
}

}  // namespace

void checkWalkParameters(const std::vector<std::string>& paths) {
  for (const std::string& path : paths)
    if (!walking::findWalkParameter(path))
      throw ConfigurationError("no walking parameter \"" + path + "\"" + suggestion(path, pathsOfWalk()));
}

std::vector<WalkVariable> variablesOf(WalkTrialKind task) {
  std::vector<WalkVariable> variables;
  const ConfigFile file("search_steps", {configFolder()});
  const ConfigSection walk = file.root().section("walk");
  const auto add = [&](const std::string& section, const std::string& key) {
    const std::vector<FirstStep> steps = firstStepsIn(walk.section(key));
    checkPaths(steps, pathsOfWalk());
    for (const FirstStep& step : steps)
      variables.push_back({section, walking::findWalkParameter(step.path), step.size});
  };
  const std::string name = walkTrialKindNames[static_cast<std::size_t>(task)];
  if (task == WalkTrialKind::mixture) {
    add("", name);
  } else if (task == WalkTrialKind::push) {
    add(recoveryName, name + "." + recoveryName);
    add("", name + ".base");
  } else {
    add(name, "corner");
    add("", name + ".base");
    add(name, name + ".corner");
  }
  return variables;
}

double valueOf(const walking::WalkGaits& gaits, const WalkVariable& variable) {
  if (variable.section == recoveryName) return variable.parameter->of(gaits.at(Vec2::Zero(), 0, 1));
  walking::WalkGaits copy = gaits;
  return variable.parameter->of(sectionOf(copy, variable.section));
}

void setValue(walking::WalkGaits& gaits, const WalkVariable& variable, double value) {
  const walking::WalkParameter& parameter = *variable.parameter;
  const double allowed = std::clamp(value, parameter.declared->range.min, parameter.declared->range.max);
  if (variable.section == recoveryName) {
    parameter.of(gaits.recovery) = allowed;
    return;
  }
  walking::WalkParameters& section = sectionOf(gaits, variable.section);
  if (&section == &gaits.base)
    gaits.setBase(parameter, allowed);
  else
    parameter.of(section) = allowed;
  if (parameter.path == "step.duration") {
    section.step.minDuration = std::max(0.04, 0.88 * section.step.duration);
    section.step.maxDuration = std::max(0.08, 1.16 * section.step.duration);
  }
}

// A fall is rare, and few tries do not tell how rare. A lean tells in each of them how far a fall is away.
double walkCost(WalkTrialKind task, const WalkTrialResult& r) {
  constexpr double ofLean = 1.5;  // [m/s per rad]
  switch (task) {
    case WalkTrialKind::forward:
      return -r.speed + 0.15 * r.drift + ofLean * r.lean;
    case WalkTrialKind::backward:
    case WalkTrialKind::sideways:
      return -r.speed + 0.3 * r.drift + ofLean * r.lean;
    case WalkTrialKind::turn:
      return -r.speed / 2.5 + 0.5 * r.drift + ofLean * r.lean;
    case WalkTrialKind::mixture:
      return -r.speed + 0.3 * r.falls;
    case WalkTrialKind::push:
      return r.falls;
  }
  return 0;
}

walking::WalkGaits trainWalk(
    const walking::WalkGaits& gaits, const WalkTrainingSetup& setup,
    const std::function<void(const std::string&, const walking::WalkGaits&)>& progress) {
  checkWalkParameters(setup.only);
  std::vector<WalkVariable> variables = variablesOf(setup.task);
  if (!setup.only.empty())
    std::erase_if(variables, [&](const WalkVariable& v) {
      return std::find(setup.only.begin(), setup.only.end(), v.parameter->path) == setup.only.end();
    });
  if (variables.empty()) throw std::invalid_argument("this task searches none of the named parameters");
  const auto n = static_cast<Eigen::Index>(variables.size());
  SearchSpace space = SearchSpace::around(Eigen::VectorXd::Zero(n), setup.sigma);
  space.lower.resize(n);
  space.upper.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const WalkVariable& v = variables[static_cast<std::size_t>(i)];
    const double start = valueOf(gaits, v);
    // A value on its bound may still move a little.
    space.lower[i] = std::min(-0.1, (v.parameter->declared->range.min - start) / v.step);
    space.upper[i] = std::max(0.1, (v.parameter->declared->range.max - start) / v.step);
  }
  const auto decode = [&](const Eigen::VectorXd& x) {
    walking::WalkGaits decoded = gaits;
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
  WalkTrialSetup tries = setup.trial;
  tries.alsoCut = true;
  const char* task = walkTrialKindNames[static_cast<std::size_t>(setup.task)];
  char line[200];
  while (!search.isDone()) {
    const Eigen::MatrixXd candidates = search.ask();
    WalkTrialSetup trial = tries;
    trial.seed = setup.seed * 100000 + static_cast<std::uint64_t>(search.generations());
    const auto count = static_cast<std::size_t>(candidates.cols());
    std::vector<double> costs(count);
    std::atomic<int> tried = 0;
    parallel(count, setup.jobs, [&](std::size_t i) {
      const walking::WalkGaits candidate = decode(candidates.col(static_cast<Eigen::Index>(i)));
      costs[i] = walkCost(setup.task, pool.tryOn(candidate, trial));
      if (setup.report)
        setup.report(std::string(task) + ", " + setup.robot,
                     (static_cast<double>(search.generations()) + ++tried / static_cast<double>(count)) /
                         setup.generations);
    });
    search.tell(costs);
    if (search.generations() % 10 == 0) {
      const walking::WalkGaits favourite = decode(search.favourite());
      const WalkTrialResult r = pool.tryOn(favourite, trial);
      std::snprintf(line, sizeof line,
                    "%s, %s, generation %d: speed %.3f, falls %.2f, drift %.3f, sigma %.3f", task,
                    setup.robot.c_str(), static_cast<int>(search.generations()), r.speed, r.falls, r.drift,
                    search.sigma());
      progress(line, favourite);
    }
    if (setup.store) setup.store(search.save());
  }
  WalkTrialSetup last = tries;
  last.seed = setup.seed * 100000 + 99999;
  last.tries *= 8;
  last.stopEarly = false;
  walking::WalkGaits found = decode(search.favourite());
  if (setup.report) setup.report("comparing what was found, " + std::string(task), -1);
  WalkTrialResult before, after;
  parallel(2, setup.jobs,
           [&](std::size_t i) { (i == 0 ? before : after) = pool.tryOn(i == 0 ? gaits : found, last); });
  if (!(walkCost(setup.task, after) < walkCost(setup.task, before))) found = gaits;
  std::snprintf(line, sizeof line,
                "%s, %s: speed %.3f, falls %.3f, drift %.3f -> speed %.3f, falls %.3f, drift %.3f", task,
                setup.robot.c_str(), before.speed, before.falls, before.drift, after.speed, after.falls,
                after.drift);
  progress(line, found);
  return found;
}

walking::WalkGaits withCornersOf(const walking::WalkGaits& gaits, const walking::WalkGaits& other) {
  walking::WalkGaits result = gaits;
  result.corner = other.corner;
  for (walking::WalkParameters& corner : result.corner)
    corner.posture.hipHeight += gaits.base.posture.hipHeight - other.base.posture.hipHeight;
  walking::SpeedParameters& speed = result.base.speed;
  speed.maxForward = other.base.speed.maxForward;
  speed.maxBackward = other.base.speed.maxBackward;
  speed.maxSideways = other.base.speed.maxSideways;
  speed.maxTurn = other.base.speed.maxTurn;
  return result;
}

std::string walkFile(const walking::WalkGaits& gaits, const walking::WalkParameters& common,
                     const std::string& heading) {
  GroupedLines base("");
  for (const walking::WalkParameter& one : walking::walkParameters())
    if (one.of(gaits.base) != one.of(common)) base.add(one.path, one.of(gaits.base));
  std::string others;
  std::size_t count = base.count;
  const auto addGait = [&](const char* name, const walking::WalkParameters& gait) {
    const bool isRecovery = &gait == &gaits.recovery;
    GroupedLines lines("    ");
    for (const walking::WalkParameter& one : walking::walkParameters()) {
      const double value = one.of(gait);
      const bool same = isRecovery ? std::isnan(value) : value == one.of(gaits.base);
      if (one.blends && !same) lines.add(one.path, value);
    }
    if (lines.count > 0) others += std::string("  ") + name + ":\n" + lines.text;
    count += lines.count;
  };
  for (std::size_t i = 0; i < walking::WalkGaits::numCorners; ++i)
    addGait(walking::WalkGaits::cornerNames[i], gaits.corner[i]);
  addGait(recoveryName, gaits.recovery);
  return "# " + heading + "\n" + overlayLine("walking.yaml", count) + "\n" + base.text +
         (others.empty() ? "" : "gaits:\n" + others);
}

}  // namespace plumbline::training
