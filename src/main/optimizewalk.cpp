#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include "framework/CommandLine.h"
#include "framework/ConfigFolder.h"
#include "framework/GuardedMain.h"
#include "framework/NearestName.h"
#include "framework/Parallel.h"
#include "framework/ProgressReport.h"
#include "framework/ReadFile.h"
#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "gap/diagnosis/ExplanationFile.h"
#include "gap/record/WalkRecording.h"
#include "optimization/Optimizers.h"
#include "servo/RobotSimulation.h"
#include "simspark/LeagueRobots.h"
#include "simulation/effects/EffectTable.h"
#include "simulation/physics/Physics.h"
#include "training/ServoWalker.h"
#include "training/WalkCheckpoint.h"
#include "training/WalkChoice.h"
#include "training/WalkTraining.h"
#include "training/WalkingRobot.h"

// bin/optimizewalk: finds the walk of a robot type in the simulator.

namespace {

using namespace plumbline;
using namespace plumbline::training;
using namespace plumbline::walking;

struct Options {
  WalkTrainingSetup setup;
  std::vector<std::string> tasks{walkTrialKindNames.begin(), walkTrialKindNames.end()};
  std::vector<std::string> searched;  ///< of the tasks, with choose
  std::string from, output;
  std::string over;  ///< folder of what is put over what was chosen
  int cornersOf = -1, type = 0;
  std::string robot;    ///< with position servos; empty: the league's type
  std::string engine;   ///< what simulates the robot; empty: the usual one
  std::string effects;  ///< file of those that the simulated robot has; empty: none
  bool anew = false, tryOnly = false, choose = false;
  ChoiceSetup choice;
  std::string checkpoint;  ///< its file, once there is one
};

std::string folderOf(const Options& options) {
  return configPath("robots/" + (options.robot.empty() ? simsparkRobotName(options.type) : options.robot));
}

void say(const std::string& line) {
  std::puts(line.c_str());
  std::fflush(stdout);
}

WalkTrialKind taskOf(const std::string& name) {
  for (std::size_t i = 0; i < walkTrialKindNames.size(); ++i)
    if (name == walkTrialKindNames[i]) return static_cast<WalkTrialKind>(i);
  throw std::invalid_argument("no task " + name);
}

/// Thrown in a robot's cycle after Ctrl-C.
struct Stopped {};

/// Of a file that need not be there, as the walk of a robot that never walked.
std::string textOf(const std::string& path) {
  constexpr std::size_t most = std::size_t{1} << 30;  // [bytes]; a program with its symbols is large
  if (!std::filesystem::exists(path)) return {};
  try {
    return readFile(path, most);
  } catch (const FileProblem& problem) {
    throw ConfigurationError(path + ": " + problem.what());
  }
}

std::string checksum(const std::string& text) {
  return fmt::format("{:08x}",
                     crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}

/// All that determines the result. The first walk is in the checkpoint itself if the search overwrites its
/// file.
std::string markOf(const Options& options) {
  const WalkTrainingSetup& setup = options.setup;
  std::string mark = fmt::format(
      "{} {}; robot {} {}; optimizer {} generations {} population {} tries {} seconds {} push {} sigma {} "
      "seed {}; anew "
      "{} corners {} "
      "choose {} choice-seed {}; tasks {}; search {}; only {}; from {}; walking.yaml {}; search_steps.yaml "
      "{}",
      versionText(), checksum(textOf("/proc/self/exe")), options.type, options.robot, setup.optimizer,
      setup.generations, setup.population, setup.trial.tries, setup.trial.seconds, setup.trial.push,
      setup.sigma, setup.seed, options.anew, options.cornersOf, options.choose, options.choice.seed,
      fmt::join(options.tasks, ","), fmt::join(options.searched, ","), fmt::join(setup.only, ","),
      options.from, checksum(textOf(configPath("walking.yaml"))),
      checksum(textOf(configPath("search_steps.yaml"))));
  const std::filesystem::path from = std::filesystem::path(options.from) / "walking.yaml";
  std::error_code error;
  if (!std::filesystem::equivalent(from, options.output, error))
    mark += "; begins with " + checksum(textOf(from));
  if (!options.over.empty()) mark += "; over " + checksum(textOf(options.over + "/walking.yaml"));
  if (!options.engine.empty()) mark += "; engine " + options.engine;
  if (!options.effects.empty()) mark += "; effects " + checksum(textOf(options.effects));
  if (!options.robot.empty())
    mark += "; robot " + checksum(textOf(configPath("robots/" + options.robot + ".json")));
  return mark;
}

/// A search that continues from its checkpoint if it was interrupted.
WalkGaits search(const WalkGaits& gaits, WalkTrainingSetup setup, WalkCheckpoint& checkpoint,
                 const std::function<void(const std::string&, const WalkGaits&)>& progress) {
  return checkpoint.stage([&] {
    setup.state = checkpoint.search();
    setup.store = [&](const std::string& state) { checkpoint.storeSearch(state); };
    return trainWalk(gaits, setup, progress);
  });
}

/// Searches and chooses: first the mixture, then each direction's sprint (the old one or the one found), then
/// all together.
void chooseAll(Options& options, WalkGaits gaits, WalkCheckpoint& checkpoint,
               const std::function<void(const WalkGaits&)>& write) {
  WalkTrainingSetup& setup = options.setup;
  const std::unique_ptr<Walker> robot = setup.walker(gaits);
  const auto sayOfRobot = [&](const std::string& line) { say(setup.robot + ", " + line); };
  const auto stage = [&](const std::string& what, const std::function<WalkGaits()>& work) {
    setup.report("choosing " + what + ", " + setup.robot, -1);
    return checkpoint.stage(work);
  };
  gaits = stage("the mixture", [&] { return chooseMixture(*robot, gaits, options.choice, sayOfRobot); });
  // Each sprint must be good alone; their combination is tested last.
  const WalkGaits none = cutSprints(gaits, 0);
  WalkGaits chosen = none;
  for (const std::string& name : options.tasks) {
    setup.task = taskOf(name);
    if (setup.task == WalkTrialKind::mixture || setup.task == WalkTrialKind::push) continue;  // no sprint
    std::vector<WalkGaits> sprints{gaits};
    if (std::ranges::find(options.searched, name) != options.searched.end())
      sprints.push_back(
          search(gaits, setup, checkpoint, [](const std::string& line, const WalkGaits&) { say(line); }));
    chosen = withSprint(
        chosen,
        stage("the sprint " + name,
              [&] { return chooseSprint(*robot, none, sprints, setup.task, options.choice, sayOfRobot); }),
        setup.task);
    write(chosen);
  }
  write(stage("all together", [&] { return chooseTogether(*robot, chosen, options.choice, sayOfRobot); }));
}

void tryTasks(const Options& options, const WalkGaits& gaits) {
  const std::unique_ptr<Walker> robot = options.setup.walker(gaits);
  for (const std::string& name : options.tasks) {
    const WalkTrialResult r = tryWalk(*robot, gaits, taskOf(name), options.setup.trial);
    say(fmt::format("{}, {}: speed {:.3f}, falls {:.3f}, drift {:.3f}", name, options.setup.robot, r.speed,
                    r.falls, r.drift));
  }
}

/// The first walk of the search.
WalkGaits firstWalk(const Options& options) {
  const ConfigFile file("walking", {configFolder(), options.from});
  WalkGaits gaits = readWalkGaits(file.root());
  file.checkUnknown();
  if (options.anew) gaits = WalkGaits(gaits.base);
  if (options.cornersOf >= 0) gaits = withCornersOf(gaits, readLeagueGaits(options.cornersOf));
  return gaits;
}

/// A robot with position servos and the league's types have engines of their own.
void checkEngine(const Options& options) {
  if (options.engine.empty()) return;
  if (!options.robot.empty()) return servo::RobotSimulations::require(options.engine);
  const std::vector<std::string>& known = simulation::physicsEngines();
  if (std::ranges::count(known, options.engine) > 0) return;
  const std::string nearest = suggestion(options.engine, known);
  throw std::invalid_argument(
      fmt::format("there is no engine {} for the league's types{}", options.engine,
                  nearest.empty() ? fmt::format("; there are: {}", fmt::join(known, ", ")) : nearest));
}

void makeRobots(Options& options, const StopSignal& stop) {
  WalkTrainingSetup& setup = options.setup;
  checkEngine(options);
  setup.robot = options.robot.empty() ? "type " + std::to_string(options.type) : options.robot;
  const auto interrupt = [&stop] {
    if (stop.requested()) throw Stopped();
  };
  std::vector<simulation::EffectSetting> effects;
  if (!options.effects.empty()) effects = simulation::readEffects(options.effects);
  if (options.robot.empty()) {
    simulation::WorldConfig world;
    world.effects = effects;
    if (!options.engine.empty()) world.engine = options.engine;
    simulation::checkEffects(effects);
    setup.walker = [type = options.type, world, interrupt](const WalkGaits& walk) {
      auto robot = std::make_unique<WalkingRobot>(type, walk, world);
      robot->interrupt = interrupt;
      return robot;
    };
  } else {
    const Mechanism mechanism = findMechanism(options.robot);
    const gap::Explanation causes = gap::causesOf(effects, mechanism);
    const std::string engine = options.engine.empty() ? servo::RobotSimulations::usual : options.engine;
    setup.walker = [engine, mechanism, causes, interrupt](const WalkGaits& walk) {
      // Without effects, too: ground and drives are those of the diagnosis, so that effects alone differ.
      std::unique_ptr<ServoWalker> robot = gap::walkerWith(engine, mechanism, walk, causes);
      robot->interrupt = interrupt;
      return robot;
    };
  }
}

void run(Options& options, const StopSignal& stop) {
  WalkTrainingSetup& setup = options.setup;
  checkWalkParameters(setup.only);
  makeRobots(options, stop);
  ProgressReport report("optimizewalk");
  setup.report = [&](const std::string& what, double share) { report.update(what, share); };
  const WalkParameters common = plainWalk().base;
  const std::string heading =
      fmt::format("Walk of the {}, found by bin/optimizewalk.",
                  options.robot.empty() ? "league's robot " + setup.robot : setup.robot);
  const auto write = [&](const WalkGaits& walk) {
    writeFile(options.output, walkFile(walk, common, heading));
  };
  if (options.tryOnly) return tryTasks(options, firstWalk(options));
  // A robot that never walked has no folder yet.
  if (std::filesystem::path(options.output).parent_path() == folderOf(options))
    std::filesystem::create_directories(folderOf(options));
  WalkCheckpoint checkpoint(options.output + ".search", markOf(options));
  options.checkpoint = checkpoint.file();
  if (checkpoint.resumed()) say("continues from " + checkpoint.file());
  WalkGaits gaits = checkpoint.stage([&] { return firstWalk(options); });
  if (options.choose) {
    const auto withOver = [&](const std::string& folder) {
      const ConfigFile whole("walking", {configFolder(), folder, options.over});
      WalkGaits walk = readWalkGaits(whole.root());
      whole.checkUnknown();
      return walk;
    };
    // A mistake in it is reported before the minutes of choosing, not after them.
    if (!options.over.empty()) withOver(options.from);
    chooseAll(options, gaits, checkpoint, write);
    if (!options.over.empty()) write(withOver(std::filesystem::path(options.output).parent_path().string()));
  } else {
    for (const std::string& name : options.tasks) {
      setup.task = taskOf(name);
      gaits = search(gaits, setup, checkpoint, [&](const std::string& line, const WalkGaits& best) {
        say(line);
        write(best);
      });
    }
    write(gaits);
  }
  checkpoint.forget();
}

int runProgram(int argc, char** argv) {
  Options options;
  WalkTrainingSetup& setup = options.setup;
  int jobs = 0;
  CommandLine app(
      "Finds the walk of a robot type in the simulator: parameters at full speed in each "
      "direction, then "
      "speeds and feedback for any mixture, and the recovery from pushes.");
  app.option("--type", options.type, "robot type: N of config/robots/simspark_typeN.json")
      .range(0, maxSimsparkTypes - 1)
      .showDefault();
  app.option("--robot", options.robot,
             "instead of a type: a robot with position servos, by the name of its file in config/robots");
  app.option("--task", options.tasks,
             "what is searched for, in this order: forward, backward, sideways, turn, mixture, push")
      .oneOf(std::vector<std::string>{walkTrialKindNames.begin(), walkTrialKindNames.end()})
      .showDefault();
  app.option("--optimizer", setup.optimizer,
             fmt::format("what searches: {}", fmt::join(optimizerNames(), ", ")))
      .check([](const std::string& name) -> std::string {
        if (std::ranges::count(optimizerNames(), name) > 0) return {};
        const std::string near = suggestion(name, optimizerNames());
        return fmt::format(
            "unknown optimiser \"{}\"{}", name,
            near.empty() ? fmt::format("; there are: {}", fmt::join(optimizerNames(), ", ")) : near);
      })
      .showDefault();
  app.option("--generations", setup.generations, "of each search").range(1, 100000).showDefault();
  app.option("--population", setup.population, "candidates of a generation").range(4, 10000).showDefault();
  app.option("--tries", setup.trial.tries, "of each candidate").range(1, 1000).showDefault();
  app.option("--seconds", setup.trial.seconds, "of one try").range(2.0, 600.0).showDefault();
  app.option("--push", setup.trial.push,
             "greatest change of velocity by a push, one a second, for the task push one a try [m/s]")
      .range(0.0, 3.0)
      .showDefault();
  app.option("--sigma", setup.sigma, "how far from the start the first generation lies, in sensible steps")
      .range(0.01, 10.0)
      .showDefault();
  app.option("--only", setup.only,
             "paths of the parameters that are searched, as step.duration; default: all of the task's");
  app.option("--seed", setup.seed, "the same seed repeats the search").showDefault();
  app.option("--from", options.from,
             "folder of the walking.yaml to begin with; default: the type's in config/");
  app.flag("--anew", options.anew, "begins with the same parameters in all directions");
  app.option("--corners-of", options.cornersOf, "begins with the directions found for another type")
      .range(0, maxSimsparkTypes - 1);
  const CommandOption choose =
      app.flag("--choose", options.choose,
               "reduces the omnidirectional walk and each sprint (of the file and of the search) until "
               "minutes of tries have no fall, and chooses the fastest");
  app.option("--search", options.searched,
             "with --choose: those of the tasks whose sprints are searched; the others are only cut")
      .oneOf(std::vector<std::string>{walkTrialKindNames.begin(), walkTrialKindNames.end()})
      .needs(choose);
  app.option("--choice-seed", options.choice.seed, "of those tries").needs(choose).showDefault();
  app.option("--over", options.over, "folder of a walking.yaml that is put over what was chosen")
      .existingFolder()
      .needs(choose);
  app.option("--jobs", jobs, "candidates tried at a time, which changes nothing else [as many as cores]")
      .range(1, 256);
  app.action("--config", useConfigFolder,
             "folder of the configuration [config/ here, else the one next to bin/]");
  app.option("--engine", options.engine,
             fmt::format("what simulates the robot: {} [{}]; with --robot: {} [{}]",
                         fmt::join(simulation::physicsEngines(), ", "), simulation::WorldConfig().engine,
                         fmt::join(servo::RobotSimulations::names(), ", "), servo::RobotSimulations::usual));
  app.option("--effects", options.effects,
             "the simulated robot has these: an answer of bin/gap diagnose --json, or a file of bin/gap "
             "apply")
      .existingFile();
  app.flag("--try", options.tryOnly, "only measures the walk at the tasks, and writes nothing");
  app.option("--output", options.output, "file to write; default: the type's in config/");
  app.footer(
      "Stopped by Ctrl-C or a loss of power it goes on where it was: FILE.search next to the output keeps "
      "what was found,\n"
      "and the same command takes it up. scripts/optimise_walks.sh repeats the search for all types.\n"
      "Examples:\n"
      "  bin/optimizewalk --type 3 --task forward --generations 50\n"
      "  bin/optimizewalk --type 3 --try\n"
      "  bin/optimizewalk --robot nao_v5 --effects answer.json --task forward --output found/walking.yaml");
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  if (options.from.empty()) options.from = folderOf(options);
  if (options.output.empty()) options.output = folderOf(options) + "/walking.yaml";
  if (!options.over.empty() && std::filesystem::path(options.output).filename() != "walking.yaml") {
    fmt::print(stderr, "optimizewalk: with --over the output is called walking.yaml, not '{}'\n",
               options.output);
    return 2;
  }
  setup.jobs = threadsFor(jobs);
  StopSignal stop;
  stop.catchSignals();
  try {
    if (options.robot.empty()) simsparkRobot(options.type);
    run(options, stop);
  } catch (const Stopped&) {
    const bool kept = !options.checkpoint.empty();
    fmt::print(stderr, "optimizewalk: stopped; {}\n",
               kept ? "the same command continues from " + options.checkpoint : "nothing was written");
    return 130;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("optimizewalk", runProgram, argc, argv); }
