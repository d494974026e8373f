#include "gap/blind/Make.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>

#include "framework/Parallel.h"
#include "framework/PartialFolder.h"
#include "gap/blind/Workshop.h"
#include "gap/record/SimulatedRecording.h"
#include "gap/run/RunFile.h"
#include "robot/MechanismCheck.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

namespace {

namespace fs = std::filesystem;
constexpr int draws = 4, sizes = 5;

/// One case in the making.
class CaseMaker {
public:
  CaseMaker(const Workshop& workshop, const Mechanism& robot, std::string folder, std::string nominal,
            std::uint64_t seed)
      : workshop_(workshop),
        robot_(robot),
        folder_(std::move(folder)),
        nominal_(std::move(nominal)),
        seed_(seed) {}

  /// One effect made as strong as it takes; its runs are left in the folder.
  bool fit(BlindEffect& effect, double most, Severity& result) const {
    for (int i = 0; i < sizes; ++i) {
      workshop_.write({effect}, seed_, true, folder_);
      result = severity(folder_, nominal_, workshop_.runs());
      if (result.ratio >= leastRatio && result.ratio <= most) return true;
      const double wanted = std::sqrt(leastRatio * most) / std::max(0.1, result.ratio);
      const BlindEffect next = strengthened(robot_, effect, std::clamp(wanted, 0.3, 3.0));
      if (next.value == effect.value) break;
      if (i + 1 < sizes) effect = next;
    }
    return result.ratio >= leastRatio;
  }

  void make(BlindCase& c, std::size_t turn, const DrawOptions& options) const {
    Random random(seed_);
    c.seed = seed_;
    const double most = c.kind == BlindKind::hard ? mostRatioOfHard : mostRatio;
    for (int draw = 0; draw < draws; ++draw) {
      c.effects = drawEffects(robot_, c.kind, turn, options, random);
      bool fits = true;
      Severity weakest{1e9, ""};
      for (BlindEffect& effect : c.effects) {
        Severity s;
        fits = fit(effect, most, s) && fits;
        if (s.ratio < weakest.ratio) weakest = s;
      }
      if (c.effects.size() != 1) workshop_.write(c.effects, seed_, true, folder_);
      if (c.effects.empty()) weakest = severity(folder_, nominal_, workshop_.runs());
      c.ratio = weakest.ratio;
      c.ratioChannel = weakest.channel;
      if (fits) return;
    }
  }

private:
  const Workshop& workshop_;
  const Mechanism& robot_;
  const std::string folder_, nominal_;
  const std::uint64_t seed_;
};

double noiseOfChannel(const std::string& channel) {
  const SensorNoise noise;
  if (channel.starts_with("pos.")) return std::hypot(noise.encoder, noise.encoderStep / std::sqrt(12.0));
  if (channel.starts_with("gyro.")) return noise.gyro;
  if (channel.starts_with("acc.")) return noise.accelerometer;
  if (channel.starts_with("fsr.")) return noise.force;
  return 0;
}

}  // namespace

std::vector<std::string> opaqueNames(std::size_t count, std::uint64_t seed) {
  Random random(seed ^ 0x0b5c);
  std::set<std::uint64_t> taken;
  std::vector<std::string> names;
  while (names.size() < count)
    if (const std::uint64_t n = 10000 + random.next() % 90000; taken.insert(n).second)
      names.push_back(std::to_string(n));
  return names;
}

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
  if (options.engine == blindReplay) options.draw.outside = false;
  const Mechanism robot = namedMechanism(options.robot);
  requirePositionServos(robot);
  const Workshop workshop(options.engine, options.robot, robot, programsOf(options.draw.battery),
                          options.program);
  std::error_code error;
  const fs::path output(options.output);
  if (fs::exists(output, error))
    throw std::runtime_error(options.output + " exists already; name a new folder with -o");
  const PartialFolder partial(options.output + ".part");
  const fs::path& part = partial.path();
  fs::remove_all(part, error);
  fs::create_directories(part, error);
  if (error) throw std::runtime_error(part.string() + " cannot be made: " + error.message());
  const std::string nominal = (part / "nominal").string();
  workshop.write({}, 1, false, nominal);
  BlindSet set;
  set.robot = options.robot;
  set.engine = options.engine;
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
}

}  // namespace plumbline::gap
