#include "gap/blind/Make.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <thread>

#include "framework/Parallel.h"
#include "framework/WriteFile.h"
#include "gap/effects/Effects.h"
#include "gap/record/ExcitationFile.h"
#include "gap/record/SimulatedRecording.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunFile.h"
#include "robot/MechanismFile.h"
#include "simspark/ChildProcess.h"

namespace plumbline::gap {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int draws = 4, sizes = 5;

std::string runName(std::size_t i) { return "run" + std::to_string(i + 1); }

/// Writes the runs of one robot with effects into a folder, in one of the engines.
class Workshop {
public:
  Workshop(const BlindMakeOptions& options_, const Mechanism& robot_)
      : options(options_), robot(robot_), programs(programsOf(options_.draw.battery)) {
    if (options.engine == BlindEngine::mujoco && access(options.program.c_str(), X_OK) != 0)
      throw std::runtime_error(options.program +
                               " is not there: `make SimRelease-bench-mujoco` builds it, or --engine replay "
                               "needs no other program");
  }

  std::vector<std::string> runs() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < programs.size(); ++i) names.push_back(runName(i));
    return names;
  }

  void write(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
             const std::string& folder) const {
    fs::remove_all(folder);
    if (options.engine == BlindEngine::mujoco)
      writeMujoco(effects, seed, noise, folder);
    else
      writeReplay(effects, seed, noise, folder);
  }

private:
  void writeMujoco(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
                   const std::string& folder) const {
    json spec = {{"robot", options.robot}, {"seed", seed}, {"noise", noise}, {"truth", false}};
    spec["effects"] = json::array();
    for (const BlindEffect& e : effects) {
      json entry = {{"effect", e.effect}, {"at", e.at}, {"value", e.value}};
      entry["axis"] = e.axis.empty() ? json(nullptr) : json(e.axis);
      for (const auto& [key, value] : e.how) entry[key] = value;
      spec["effects"].push_back(entry);
    }
    for (std::size_t i = 0; i < programs.size(); ++i)
      spec["runs"].push_back({{"folder", runName(i)}, {"program", programs[i]}, {"seed", 0}});
    const std::string file = folder + ".case.json", log = folder + ".log";
    writeFile(file, spec.dump());
    simspark::ChildProcess child({options.program, file, folder}, log);
    while (child.running()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::string said, line;
    std::ifstream text(log);
    while (std::getline(text, line))
      if (!line.empty()) said = line;
    fs::remove(file);
    fs::remove(log);
    if (child.exitStatus() != 0) throw std::runtime_error(options.program + " failed: " + said);
  }

  void writeReplay(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
                   const std::string& folder) const {
    SimulatedRecordingOptions recording;
    recording.noisy = noise;
    recording.step = 0.0005;  // a quarter of what the diagnosis takes
    for (const BlindEffect& e : effects) {
      const Effect* effect = findEffect(e.effect);
      if (!effect) throw std::runtime_error("the project's replay has no effect " + e.effect);
      recording.effects.push_back({effect, findPlace(*effect, robot, e.at, e.axis), e.value, 0});
    }
    fs::create_directories(folder);
    for (std::size_t i = 0; i < programs.size(); ++i) {
      recording.seed = seed * 1'000'003 + i + 1;
      const Run run = recordSimulated(robot, findExcitation(programs[i], robot), recording);
      writeRun(run, (fs::path(folder) / runName(i)).string(), {5, true});
    }
  }

  const BlindMakeOptions& options;
  const Mechanism& robot;
  const std::vector<std::string> programs;
};

/// One case in the making.
class CaseMaker {
public:
  CaseMaker(const Workshop& workshop_, const Mechanism& robot_, std::string folder_, std::string nominal_,
            std::uint64_t seed_)
      : workshop(workshop_),
        robot(robot_),
        folder(std::move(folder_)),
        nominal(std::move(nominal_)),
        seed(seed_) {}

  /// One effect made as strong as it takes; its runs are left in the folder.
  bool fit(BlindEffect& effect, double most, Severity& result) const {
    for (int i = 0; i < sizes; ++i) {
      workshop.write({effect}, seed, true, folder);
      result = severity(folder, nominal, workshop.runs());
      if (result.ratio >= leastRatio && result.ratio <= most) return true;
      const double wanted = std::sqrt(leastRatio * most) / std::max(0.1, result.ratio);
      const BlindEffect next = strengthened(robot, effect, std::clamp(wanted, 0.3, 3.0));
      if (next.value == effect.value) break;
      if (i + 1 < sizes) effect = next;
    }
    return result.ratio >= leastRatio;
  }

  void make(BlindCase& c, std::size_t turn, const DrawOptions& options) const {
    Random random(seed);
    c.seed = seed;
    const double most = c.kind == BlindKind::hard ? mostRatioOfHard : mostRatio;
    for (int draw = 0; draw < draws; ++draw) {
      c.effects = drawEffects(robot, c.kind, turn, options, random);
      bool fits = true;
      Severity weakest{1e9, ""};
      for (BlindEffect& effect : c.effects) {
        Severity s;
        fits = fit(effect, most, s) && fits;
        if (s.ratio < weakest.ratio) weakest = s;
      }
      if (c.effects.size() != 1) workshop.write(c.effects, seed, true, folder);
      if (c.effects.empty()) weakest = severity(folder, nominal, workshop.runs());
      c.ratio = weakest.ratio;
      c.ratioChannel = weakest.channel;
      if (fits) return;
    }
  }

private:
  const Workshop& workshop;
  const Mechanism& robot;
  const std::string folder, nominal;
  const std::uint64_t seed;
};

/// Numbers that say nothing, each once.
std::vector<std::string> opaqueNames(std::size_t count, std::uint64_t seed) {
  Random random(seed ^ 0x0b5c);
  std::set<std::uint64_t> taken;
  std::vector<std::string> names;
  while (names.size() < count)
    if (const std::uint64_t n = 10000 + random.next() % 90000; taken.insert(n).second)
      names.push_back(std::to_string(n));
  return names;
}

double noiseOfChannel(const std::string& channel) {
  const SensorNoise noise;
  if (channel.starts_with("pos.")) return std::hypot(noise.encoder, noise.encoderStep / std::sqrt(12.0));
  if (channel.starts_with("gyro.")) return noise.gyro;
  if (channel.starts_with("acc.")) return noise.accelerometer;
  if (channel.starts_with("fsr.")) return noise.force;
  return 0;
}

}  // namespace

Severity severity(const std::string& folder, const std::string& nominal,
                  const std::vector<std::string>& runs) {
  Severity worst;
  std::vector<RunWarning> ignored;
  for (const std::string& name : runs) {
    const Run run = readRun((fs::path(folder) / name).string(), ignored);
    const Run clean = readRun((fs::path(nominal) / name).string(), ignored);
    for (const auto& [channel, values] : run.channels) {
      const double sigma = noiseOfChannel(channel);
      const std::vector<double>* other = clean.find(channel);
      if (sigma <= 0 || !other) continue;
      double sum = 0, n = 1e-9;
      for (std::size_t k = 0; k < std::min(values.size(), other->size()); ++k) {
        const double d = (values[k] - (*other)[k]) / sigma;
        if (!std::isfinite(d)) continue;
        sum += d * d;
        ++n;
      }
      const double ratio = std::sqrt(std::max(0.0, sum / n - 1));
      if (ratio > worst.ratio) worst = {ratio, name + "/" + channel};
    }
  }
  return worst;
}

BlindSet makeBlind(const BlindMakeOptions& given) {
  BlindMakeOptions options = given;
  if (options.engine == BlindEngine::replay) options.draw.outside = false;
  const Mechanism robot = namedMechanism(options.robot);
  const Workshop workshop(options, robot);
  std::error_code error;
  const fs::path output(options.output);
  if (fs::exists(output, error))
    throw std::runtime_error(options.output + " is there already; name a new folder with -o");
  const fs::path part(options.output + ".part");
  fs::remove_all(part, error);
  fs::create_directories(part, error);
  if (error) throw std::runtime_error(part.string() + " cannot be made: " + error.message());
  try {
    const std::string nominal = (part / "nominal").string();
    workshop.write({}, 1, false, nominal);
    BlindSet set;
    set.robot = options.robot;
    set.engine = options.engine == BlindEngine::mujoco ? "mujoco" : "replay";
    set.battery = options.draw.battery == Battery::hang ? "hang" : "all";
    set.seed = options.draw.seed;
    const std::vector<BlindKind> kinds = drawKinds(options.draw);
    const std::vector<std::string> names = opaqueNames(kinds.size(), options.draw.seed);
    std::vector<std::size_t> turns;
    std::map<BlindKind, std::size_t> count;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      BlindCase c;
      c.name = names[i];
      c.kind = kinds[i];
      set.cases.push_back(std::move(c));
      turns.push_back(count[kinds[i]]++);
    }
    std::mutex mutex;
    std::size_t done = 0;
    parallel(set.cases.size(), options.jobs, [&](std::size_t i) {
      BlindCase& c = set.cases[i];
      const CaseMaker maker(workshop, robot, (part / c.name).string(), nominal,
                            options.draw.seed * 1'000'003 + i);
      maker.make(c, turns[i], options.draw);
      const std::lock_guard lock(mutex);
      ++done;
      if (options.progress) options.progress(done);
    });
    std::ranges::sort(set.cases, {}, &BlindCase::name);
    writeSealed(set, part.string());
    fs::remove_all(nominal);
    fs::rename(part, output);
    return set;
  } catch (...) {
    fs::remove_all(part, error);
    throw;
  }
}

}  // namespace plumbline::gap
