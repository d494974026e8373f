#include "gap/blind/PlantedSet.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <stdexcept>

#include "framework/Parallel.h"
#include "framework/PartialFolder.h"
#include "framework/WriteFile.h"
#include "gap/blind/Make.h"
#include "gap/blind/PlantedCase.h"
#include "gap/run/RunCheck.h"
#include "gap/run/RunFile.h"
#include "robot/MechanismFile.h"
#include "robot/MechanismWriter.h"

namespace plumbline::gap {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostRuns = 100;
constexpr int digits = 9;  ///< so that what was recorded stays as it was

RealRecordings recordingsOf(const PlantedSetOptions& options, std::vector<RunWarning>& warnings) {
  std::vector<std::string> folders;
  for (const std::string& path : options.from)
    for (const std::string& folder : findRuns(path)) folders.push_back(folder);
  if (folders.size() > mostRuns)
    throw std::runtime_error("more than " + std::to_string(mostRuns) + " recordings; choose some of them");
  std::vector<RunWarning> ignored;
  const std::string name = options.robot.empty() ? readRun(folders.front(), ignored).robot : options.robot;
  const Mechanism robot = options.robot.empty() ? findMechanism(name) : namedMechanism(name);
  std::vector<Run> runs;
  for (const std::string& folder : folders) {
    Run run = readCheckedRun(folder, robot, warnings);
    if (run.freeBase)
      throw std::runtime_error(folder +
                               ": its base is free; causes are planted in recordings of a robot whose "
                               "base is fixed");
    // An entry for all joints beside those of some could not be written.
    if (run.timing.size() > 1 && run.timing.count("*")) {
      for (const Mechanism::Joint& joint : robot.joints)
        run.timing.try_emplace(joint.name, run.timing.at("*"));
      run.timing.erase("*");
    }
    runs.push_back(std::move(run));
  }
  return {robot, std::move(runs)};
}

void writeCase(const RealRecordings& recordings, const fs::path& folder) {
  fs::create_directories(folder);
  writeFile((folder / "robot.json").string(), mechanismText(recordings.robot));
  for (std::size_t i = 0; i < recordings.runs.size(); ++i)
    writeRun(recordings.runs[i], (folder / ("run" + std::to_string(i + 1))).string(), {digits, true});
}

}  // namespace

std::vector<BlindCase> drawPlantedCases(std::size_t cases, std::uint64_t seed) {
  DrawOptions options{.cases = cases, .seed = seed, .outside = false};
  std::vector<BlindCase> list;
  const std::vector<std::string> names = opaqueNames(cases, seed);
  std::vector<BlindKind> kinds = drawKinds(options);
  // Small causes that are easily confused have no range of sizes here.
  std::ranges::replace(kinds, BlindKind::hard, BlindKind::single);
  // One more is needed with nothing planted: the one that the others are compared with.
  kinds.insert(kinds.begin(), BlindKind::none);
  kinds.resize(cases);
  for (std::size_t i = 0; i < cases; ++i) {
    BlindCase c;
    c.name = names[i];
    c.kind = kinds[i];
    c.reference = i == 0;
    c.seed = seed * 1'000'003 + i;
    list.push_back(std::move(c));
  }
  return list;
}

BlindSet makePlantedSet(const PlantedSetOptions& options, std::vector<RunWarning>& warnings) {
  std::error_code error;
  if (fs::exists(options.output, error))
    throw std::runtime_error(options.output + " exists already; name a new folder with -o");
  const PlantingBase base(recordingsOf(options, warnings));
  const PartialFolder partial(options.output + ".part");
  const fs::path& part = partial.path();
  fs::remove_all(part, error);
  fs::create_directories(part, error);
  if (error) throw std::runtime_error(part.string() + " cannot be made: " + error.message());
  BlindSet set;
  set.robot = base.recordings.robot.name;
  set.engine = blindRecordings;
  set.battery = "recordings";
  set.seed = options.seed;
  set.cases = drawPlantedCases(options.cases, options.seed);
  std::vector<std::size_t> turns;
  for (std::size_t i = 0, turn = 0; i < set.cases.size(); ++i) {
    turns.push_back(turn);
    turn += set.cases[i].kind == BlindKind::none ? 0 : set.cases[i].kind == BlindKind::mixture ? 2 : 1;
  }
  std::mutex mutex;
  std::size_t done = 0;
  parallel(set.cases.size(), options.jobs, [&](std::size_t i) {
    BlindCase& c = set.cases[i];
    Random random(c.seed);
    writeCase(plantCase(base, turns[i], random, c), part / c.name);
    const std::lock_guard lock(mutex);
    ++done;
    if (options.progress) options.progress(done);
  });
  std::ranges::sort(set.cases, {}, &BlindCase::name);
  writeSealed(set, part.string());
  fs::rename(part, options.output);
  return set;
}

}  // namespace plumbline::gap
