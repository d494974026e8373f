// The reality of the diagnosis's benchmark: a robot in MuJoCo with effects on, which plays excitation
// programs and writes runs.
//
//   bench/mujoco CASE.json FOLDER     writes the runs of a case into FOLDER/<run>
//   bench/mujoco                      speed, and how far the project's dynamics are from this engine's with
//                                     nothing unmodelled; written to build/bench/mujoco.json
//
// CASE.json: {"robot": "nao_v5", "seed": 1, "noise": true, "truth": false, "step": 0.0002,
//   "effects": [{"effect": "backlash", "at": "LKneePitch", "axis": null, "value": 0.03, "side": "motor"}],
//   "runs": [{"folder": "run1", "program": "hang_sweep", "seed": 0}]}
// A run's program is a name in config/excitation or the path of a file; its seed draws what is random in it.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Reality.h"
#include "gap/record/ExcitationFile.h"
#include "gap/replay/Replay.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunFile.h"
#include "robot/MechanismFile.h"

using namespace plumbline;
using nlohmann::json;

namespace {

reality::RealityEffect readEffect(const json& entry) {
  reality::RealityEffect effect;
  for (const auto& [key, value] : entry.items()) {
    if (key == "effect")
      effect.effect = value.get<std::string>();
    else if (key == "at")
      effect.at = value.get<std::string>();
    else if (key == "value")
      effect.value = value.get<double>();
    else if (key == "axis")
      effect.axis = value.is_null() ? "" : value.get<std::string>();
    else if (value.is_string())
      effect.how[key] = value.get<std::string>();
    else if (value.is_number())
      effect.how[key] = value.dump();
  }
  return effect;
}

gap::Excitation programOf(const std::string& name, const Mechanism& robot, std::uint64_t seed) {
  return name.find('/') == std::string::npos ? gap::findExcitation(name, robot, seed)
                                             : gap::readExcitation(name, robot, seed);
}

void writeCase(const std::string& file, const std::string& folder) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file + ": cannot be read");
  const json spec = json::parse(stream);
  const Mechanism robot = namedMechanism(spec.at("robot").get<std::string>());
  std::vector<reality::RealityEffect> effects;
  for (const json& entry : spec.at("effects")) effects.push_back(readEffect(entry));
  reality::RealityOptions options;
  options.noise = spec.value("noise", true);
  options.truth = spec.value("truth", false);
  options.step = spec.value("step", options.step);
  const reality::Reality world(robot, effects, options);
  const auto seed = spec.value("seed", std::uint64_t{1});
  std::filesystem::create_directories(folder);
  std::uint64_t number = 0;
  for (const json& entry : spec.at("runs")) {
    const gap::Excitation program =
        programOf(entry.at("program").get<std::string>(), robot, entry.value("seed", std::uint64_t{0}));
    gap::writeRun(world.record(program, seed * 1'000'003 + ++number),
                  (std::filesystem::path(folder) / entry.at("folder").get<std::string>()).string(),
                  {5, true});
  }
}

/// Largest root mean square, over the signals of a kind, of what the project's own dynamics say beside this
/// engine, nothing unmodelled, in units of the sensors' noise: what no diagnosis may call a gap.
double engineDifference(const Mechanism& robot, const gap::Run& run, gap::SignalKind kind, double noise) {
  const gap::Trial trial = gap::trialOf(run, robot);
  gap::ReplayOptions options;
  options.settle = run.freeBase ? 2 : 1;
  const gap::Prediction prediction = gap::replay(gap::nominalPlant(robot), trial, options);
  double worst = 0;
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    if (trial.signals[s].kind != kind) continue;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < prediction.values[s].size(); ++i) {
      const double difference = (prediction.values[s][i] - trial.signals[s].values[i]) / noise;
      if (std::isfinite(difference)) sum += difference * difference, ++count;
    }
    if (count > 0) worst = std::max(worst, std::sqrt(sum / count));
  }
  return worst;
}

void measure() {
  json report = json::array();
  const auto add = [&](const std::string& name, double value, const char* unit, const char* better) {
    std::printf("%-34s %8.3g %s\n", name.c_str(), value, unit);
    report.push_back({{"name", "mujoco." + name}, {"value", value}, {"unit", unit}, {"better", better}});
  };
  const Mechanism nao = findMechanism("nao_v5");
  reality::RealityOptions options;
  options.noise = false;
  const double encoder = std::hypot(options.encoderNoise, options.encoderStep / std::sqrt(12.0));
  for (const char* name : {"hang_sweep", "hang_multisine", "hang_fast", "stand_squat", "stand_sway"}) {
    const gap::Excitation program = gap::findExcitation(name, nao);
    const auto begin = std::chrono::steady_clock::now();
    const gap::Run run = reality::Reality(nao, {}, options).record(program, 1);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::string motion = name;
    add(motion + ".speed", run.duration() / seconds, "x real time", "higher");
    add(motion + ".position", engineDifference(nao, run, gap::SignalKind::position, encoder), "noise",
        "lower");
    if (!run.freeBase) continue;
    add(motion + ".gyro", engineDifference(nao, run, gap::SignalKind::gyro, options.gyroNoise), "noise",
        "lower");
    add(motion + ".acc", engineDifference(nao, run, gap::SignalKind::accelerometer, options.accNoise),
        "noise", "lower");
    add(motion + ".fsr", engineDifference(nao, run, gap::SignalKind::force, options.forceNoise), "noise",
        "lower");
  }
  std::ofstream("build/bench/mujoco.json") << report.dump(1) << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 3)
      writeCase(argv[1], argv[2]);
    else if (argc == 1)
      measure();
    else
      throw std::runtime_error("give CASE.json and FOLDER, or nothing");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
