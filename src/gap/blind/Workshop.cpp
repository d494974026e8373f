#include "gap/blind/Workshop.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "framework/FileLines.h"
#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "gap/blind/OutsideDrives.h"
#include "gap/effects/Effects.h"
#include "gap/record/EngineRecording.h"
#include "gap/record/ExcitationFile.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunFile.h"
#include "servo/RobotSimulation.h"
#include "simspark/ChildProcess.h"

namespace plumbline::gap {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double stepHere = 0.0005;  ///< a quarter of what the diagnosis takes [s]

std::string runName(std::size_t i) { return "run" + std::to_string(i + 1); }

/// An effect of the library as its plug-in takes it: a gear that gives way has its encoder on the side that
/// was drawn.
Cause causeOf(const BlindEffect& e, const Effect& effect, const Mechanism& robot) {
  Cause cause{&effect, findPlace(effect, robot, e.at, e.axis), e.value, 0};
  const auto side = e.how.find("side");
  if (side == e.how.end() || cause.place.site != Site::joint) return cause;
  const Mechanism::Joint& joint = robot.joints[static_cast<std::size_t>(cause.place.index)];
  const bool atLink = joint.encoder == Mechanism::Joint::Encoder::link;
  cause.variant = atLink == (side->second == "link") ? 0 : 1;
  return cause;
}

}  // namespace

void requireBlindEngine(const std::string& engine) {
  servo::RobotSimulations::require(engine, {blindProgram, blindReplay});
}

Workshop::Workshop(std::string engine, std::string robotName, const Mechanism& robot,
                   std::vector<std::string> programs, std::string program)
    : engine_(std::move(engine)),
      robotName_(std::move(robotName)),
      robot_(robot),
      programs_(std::move(programs)),
      program_(std::move(program)) {
  requireBlindEngine(engine_);
  if (engine_ == blindProgram && access(program_.c_str(), X_OK) != 0)
    throw std::runtime_error(program_ +
                             " is not there: `make SimRelease-bench-mujoco` builds it, or --engine bullet "
                             "needs no other program");
}

std::vector<std::string> Workshop::runs() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < programs_.size(); ++i) names.push_back(runName(i));
  return names;
}

void Workshop::write(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
                     const std::string& folder) const {
  fs::remove_all(folder);
  if (engine_ == blindProgram)
    writeByProgram(effects, seed, noise, folder);
  else
    writeHere(effects, seed, noise, folder);
}

void Workshop::writeByProgram(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
                              const std::string& folder) const {
  json spec = {{"robot", robotName_}, {"seed", seed}, {"noise", noise}, {"truth", false}};
  spec["effects"] = json::array();
  for (const BlindEffect& e : effects) {
    json entry = {{"effect", e.effect}, {"at", e.at}, {"value", e.value}};
    entry["axis"] = e.axis.empty() ? json(nullptr) : json(e.axis);
    for (const auto& [key, value] : e.how) entry[key] = value;
    spec["effects"].push_back(entry);
  }
  for (std::size_t i = 0; i < programs_.size(); ++i)
    spec["runs"].push_back({{"folder", runName(i)}, {"program", programs_[i]}, {"seed", 0}});
  const std::string file = folder + ".case.json", log = folder + ".log";
  writeFile(file, spec.dump());
  simspark::ChildProcess child({program_, file, folder}, log);
  while (child.running()) {
    StopSignal::throwIfCaught();  // and the child ends with its owner
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::string said, line;
  FileLines lines(log);
  while (lines.next(line))
    if (!line.empty()) said = line;
  fs::remove(file);
  fs::remove(log);
  if (child.exitStatus() != 0) throw std::runtime_error(program_ + " failed: " + said);
}

void Workshop::writeHere(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
                         const std::string& folder) const {
  SimulatedRecordingOptions recording;
  recording.noisy = noise;
  recording.step = stepHere;
  std::vector<BlindEffect> outside;
  for (const BlindEffect& e : effects) {
    const Effect* effect = findEffect(e.effect);
    if (effect)
      recording.effects.push_back(causeOf(e, *effect, robot_));
    else if (engine_ != blindReplay)
      outside.push_back(e);
    else
      throw std::runtime_error("the project's replay has no effect " + e.effect);
  }
  fs::create_directories(folder);
  for (std::size_t i = 0; i < programs_.size(); ++i) {
    recording.seed = seed * 1'000'003 + i + 1;
    const Excitation motion = findExcitation(programs_[i], robot_);
    OutsideDrives drives(robot_, outside);
    const Run run = engine_ == blindReplay ? recordSimulated(robot_, motion, recording)
                                           : recordInEngine(engine_, robot_, motion, recording,
                                                            outside.empty() ? nullptr : &drives);
    writeRun(run, (fs::path(folder) / runName(i)).string(), {5, true});
  }
}

}  // namespace plumbline::gap
