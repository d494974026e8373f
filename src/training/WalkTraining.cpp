#include "training/WalkTraining.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "optimization/Cmaes.h"

namespace plumbline::walking {
namespace {

constexpr const char* recoveryName = "recovery";

struct Step {
  const char* name;
  double step;
};

constexpr Step shape[] = {
    {"hipHeight", 0.006},    {"feetDistance", 0.006},  {"torsoPitch", 0.04},      {"trimForward", 0.02},
    {"stepDuration", 0.008}, {"maxStepForward", 0.02}, {"maxStepBackward", 0.02}, {"maxStepOutward", 0.02},
    {"stepHeight", 0.006},   {"swingStart", 0.06},     {"swingEnd", 0.06},        {"swingSmoothness", 0.15},
    {"swingSteepness", 0.2}, {"swingPitch", 0.06},     {"pendulumHeight", 0.03},  {"pendulumSideways", 0.03},
    {"copForward", 0.006},   {"copOutward", 0.006},    {"armSwing", 1.5},
};
constexpr Step feedback[] = {
    {"delay", 0.01},          {"ankleRollGain", 0.1},   {"anklePitchGain", 0.1},   {"ankleRollRate", 0.01},
    {"anklePitchRate", 0.01}, {"hipRollGain", 0.1},     {"hipPitchGain", 0.1},     {"hipRollRate", 0.01},
    {"hipPitchRate", 0.01},   {"stepForwardGain", 0.1}, {"stepSidewaysGain", 0.1}, {"swingLevel", 0.2},
    {"comForwardGain", 0.1},  {"comSidewaysGain", 0.1},
};

constexpr Step recovery[] = {
    {"observationPosition", 0.2}, {"observationVelocity", 0.2}, {"observationSideways", 0.3},
    {"observationBeside", 0.3},   {"swingMeasuredPitch", 0.3},  {"swingMeasuredRoll", 0.3},
    {"torsoMeasured", 0.2},       {"maxStepForward", 0.03},     {"maxStepBackward", 0.03},
    {"maxStepOutward", 0.03},     {"feetDistance", 0.01},       {"stepHeight", 0.006},
    {"pendulumHeight", 0.03},     {"pendulumSideways", 0.03},   {"copForward", 0.01},
    {"stepForwardGain", 0.2},     {"stepSidewaysGain", 0.2},    {"swingLevel", 0.3},
    {"anklePitchGain", 0.15},     {"ankleRollGain", 0.15},      {"anklePitchRate", 0.015},
    {"ankleRollRate", 0.015},     {"hipPitchGain", 0.15},       {"hipRollGain", 0.15},
};

const WalkParameterInfo* infoOf(const std::string& name) {
  for (const WalkParameterInfo& info : walkParameterTable())
    if (name == info.name) return &info;
  throw std::invalid_argument("no walking parameter " + name);
}

WalkParameters& sectionOf(WalkGaits& gaits, const std::string& name) {
  for (std::size_t i = 0; i < WalkGaits::numCorners; ++i)
    if (name == WalkGaits::cornerNames[i]) return gaits.corner[i];
  return gaits.base;
}

}  // namespace

std::vector<Variable> variablesOf(Task task) {
  std::vector<Variable> variables;
  const auto add = [&](const std::string& section, const char* name, double step) {
    variables.push_back({section, infoOf(name), step});
  };
  if (task == Task::mixture) {
    for (const Step& s : feedback) add("", s.name, s.step / 2);
    add("", "maxForward", 0.05);
    add("", "maxBackward", 0.05);
    add("", "maxSideways", 0.05);
    add("", "maxTurn", 0.15);
    add("", "accelerationForward", 0.15);
    add("", "decelerationForward", 0.15);
    add("", "accelerationSideways", 0.1);
    add("", "accelerationTurn", 1);
    add("", "tiltTolerance", 0.05);
    add("", "tiltBrake", 1);
    add("", "startDuration", 0.01);
    return variables;
  }
  if (task == Task::push) {
    for (const Step& s : recovery) add(recoveryName, s.name, s.step);
    // Not when it begins to recover: with nothing but pushes that would be always.
    add("", "recoverTime", 0.2);
    add("", "captureMargin", 0.015);
    return variables;
  }
  const std::string corner = taskNames[static_cast<std::size_t>(task)];
  for (const Step& s : shape) add(corner, s.name, s.step);
  for (const Step& s : feedback) add(corner, s.name, s.step);
  switch (task) {
    case Task::forward:
      add("", "maxForward", 0.15);
      add(corner, "brakeLead", 0.03);
      break;
    case Task::backward:
      add("", "maxBackward", 0.15);
      add(corner, "brakeLead", 0.03);
      break;
    case Task::sideways:
      add("", "maxSideways", 0.1);
      add(corner, "accelerationSideways", 0.1);
      break;
    case Task::turn:
      add("", "maxTurn", 0.4);
      break;
    case Task::mixture:
    case Task::push:
      break;
  }
  return variables;
}

double valueOf(const WalkGaits& gaits, const Variable& variable) {
  if (variable.section == recoveryName) return gaits.at(Vec2::Zero(), 0, 1).*variable.info->value;
  WalkGaits copy = gaits;
  return sectionOf(copy, variable.section).*variable.info->value;
}

void setValue(WalkGaits& gaits, const Variable& variable, double value) {
  if (variable.section == recoveryName) {
    std::erase_if(gaits.recovery, [&](const auto& other) { return other.first == variable.info; });
    gaits.recovery.emplace_back(variable.info, std::clamp(value, variable.info->low, variable.info->high));
    return;
  }
  WalkParameters& section = sectionOf(gaits, variable.section);
  const double before = section.*variable.info->value;
  section.*variable.info->value = std::clamp(value, variable.info->low, variable.info->high);
  if (&section == &gaits.base)
    for (WalkParameters& corner : gaits.corner)
      if (corner.*variable.info->value == before)
        corner.*variable.info->value = section.*variable.info->value;
  if (std::string(variable.info->name) == "stepDuration") {
    section.minStepDuration = std::max(0.04, 0.88 * section.stepDuration);
    section.maxStepDuration = std::max(0.08, 1.16 * section.stepDuration);
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
  std::vector<Variable> variables = variablesOf(setup.task);
  if (!setup.only.empty())
    std::erase_if(variables, [&](const Variable& v) {
      return std::find(setup.only.begin(), setup.only.end(), v.info->name) == setup.only.end();
    });
  if (variables.empty())
    throw std::invalid_argument("none of the parameters named is searched for this task");
  const auto n = static_cast<Eigen::Index>(variables.size());
  SearchSpace space = SearchSpace::around(Eigen::VectorXd::Zero(n), setup.sigma);
  space.lower.resize(n);
  space.upper.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Variable& v = variables[static_cast<std::size_t>(i)];
    const double start = valueOf(gaits, v);
    // A value on its bound may still move a little.
    space.lower[i] = std::min(-0.1, (v.info->low - start) / v.step);
    space.upper[i] = std::max(0.1, (v.info->high - start) / v.step);
  }
  const auto decode = [&](const Eigen::VectorXd& x) {
    WalkGaits decoded = gaits;
    for (std::size_t i = 0; i < variables.size(); ++i)
      setValue(decoded, variables[i],
               valueOf(gaits, variables[i]) + variables[i].step * x[static_cast<Eigen::Index>(i)]);
    return decoded;
  };
  CmaesOptions options;
  options.population = setup.population;
  options.seed = setup.seed;
  options.stop.maxGenerations = setup.generations;
  Cmaes search(space, options);
  const std::unique_ptr<Walker> walker = setup.walker(gaits);
  Walker& robot = *walker;
  const char* task = taskNames[static_cast<std::size_t>(setup.task)];
  char line[200];
  while (!search.isDone()) {
    const Eigen::MatrixXd candidates = search.ask();
    TrialSetup trial = setup.trial;
    trial.seed = setup.seed * 100000 + static_cast<std::uint64_t>(search.generations());
    std::vector<double> costs;
    for (Eigen::Index i = 0; i < candidates.cols(); ++i)
      costs.push_back(cost(setup.task, tryWalk(robot, decode(candidates.col(i)), setup.task, trial)));
    search.tell(costs);
    if (search.generations() % 10 != 0) continue;
    const WalkGaits favourite = decode(search.favourite());
    const TrialResult r = tryWalk(robot, favourite, setup.task, trial);
    std::snprintf(line, sizeof line, "%s, %s, generation %d: speed %.3f, falls %.2f, drift %.3f, sigma %.3f",
                  task, setup.robot.c_str(), static_cast<int>(search.generations()), r.speed, r.falls,
                  r.drift, search.sigma());
    progress(line, favourite);
  }
  TrialSetup last = setup.trial;
  last.seed = setup.seed * 100000 + 99999;
  last.tries *= 8;
  last.stopEarly = false;
  WalkGaits found = decode(search.favourite());
  const TrialResult before = tryWalk(robot, gaits, setup.task, last),
                    after = tryWalk(robot, found, setup.task, last);
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
    corner.hipHeight += gaits.base.hipHeight - other.base.hipHeight;
  for (const WalkParameterInfo& info : walkParameterTable()) {
    const std::string name = info.name;
    if (!info.blends && name.starts_with("max")) result.base.*info.value = other.base.*info.value;
  }
  return result;
}

std::string walkFile(const WalkGaits& gaits, const WalkParameters& common, const std::string& heading) {
  std::string text = "# " + heading + "\n";
  const auto line = [&](const char* indent, const WalkParameterInfo& info, double value) {
    char buffer[100];
    std::snprintf(buffer, sizeof buffer, "%s%s: %.5g\n", indent, info.name, value);
    text += buffer;
  };
  for (const WalkParameterInfo& info : walkParameterTable())
    if (gaits.base.*info.value != common.*info.value) line("", info, gaits.base.*info.value);
  for (std::size_t i = 0; i < WalkGaits::numCorners; ++i) {
    bool first = true;
    for (const WalkParameterInfo& info : walkParameterTable()) {
      const double value = gaits.corner[i].*info.value;
      if (!info.blends || value == gaits.base.*info.value) continue;
      if (first) text += std::string(WalkGaits::cornerNames[i]) + ":\n";
      first = false;
      line("  ", info, value);
    }
  }
  if (!gaits.recovery.empty()) text += std::string(recoveryName) + ":\n";
  for (const auto& [info, value] : gaits.recovery) line("  ", *info, value);
  return text;
}

}  // namespace plumbline::walking
