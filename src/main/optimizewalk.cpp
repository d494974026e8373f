#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "framework/WriteFile.h"
#include "training/ServoWalker.h"
#include "training/WalkChoice.h"
#include "training/WalkTraining.h"
#include "training/WalkingRobot.h"

// bin/optimizewalk: finds the walk of a robot type in the simulator.

namespace {

using namespace plumbline;
using namespace plumbline::walking;

struct Options {
  TrainingSetup setup;
  std::vector<std::string> tasks{taskNames.begin(), taskNames.end()};
  std::vector<std::string> searched;  ///< of the tasks, with choose
  std::string from, output;
  std::string over;  ///< folder of what is put over what was chosen
  int cornersOf = -1, type = 0;
  std::string robot;  ///< with position servos; empty: the league's type
  bool anew = false, tryOnly = false, choose = false;
  ChoiceSetup choice;
};

std::string folderOf(const Options& options) {
  return "config/robots/" + (options.robot.empty() ? "type" + std::to_string(options.type) : options.robot);
}

void say(const std::string& line) {
  std::puts(line.c_str());
  std::fflush(stdout);
}

Task taskOf(const std::string& name) {
  for (std::size_t i = 0; i < taskNames.size(); ++i)
    if (name == taskNames[i]) return static_cast<Task>(i);
  throw std::invalid_argument("no task " + name);
}

/// Searches and chooses: the mixture first, then each direction's sprint between what was there and what is
/// found, then all together.
void chooseAll(Options& options, WalkGaits gaits, const std::function<void(const WalkGaits&)>& write) {
  TrainingSetup& setup = options.setup;
  const std::unique_ptr<Walker> robot = setup.walker(gaits);
  const auto tell = [&](const std::string& line) { say(setup.robot + ", " + line); };
  gaits = chooseMixture(*robot, gaits, options.choice, tell);
  // Each sprint has to hold alone; what they do together comes last.
  const WalkGaits none = cutSprints(gaits, 0);
  WalkGaits chosen = none;
  for (const std::string& name : options.tasks) {
    setup.task = taskOf(name);
    if (setup.task == Task::mixture || setup.task == Task::push) continue;  // no sprint
    std::vector<WalkGaits> sprints{gaits};
    if (std::ranges::find(options.searched, name) != options.searched.end())
      sprints.push_back(train(gaits, setup, [](const std::string& line, const WalkGaits&) { say(line); }));
    chosen =
        withSprint(chosen, chooseSprint(*robot, none, sprints, setup.task, options.choice, tell), setup.task);
    write(chosen);
  }
  write(chooseTogether(*robot, chosen, options.choice, tell));
}

void run(Options& options) {
  TrainingSetup& setup = options.setup;
  const ConfigFile file("walking", {"config", options.from});
  WalkGaits gaits = readWalkGaits(file.root());
  if (options.anew) gaits = WalkGaits(gaits.base);
  if (options.cornersOf >= 0) gaits = withCornersOf(gaits, readWalkGaits(options.cornersOf));
  const WalkParameters common = plainWalk().base;
  setup.robot = options.robot.empty() ? "type " + std::to_string(options.type) : options.robot;
  if (options.robot.empty())
    setup.walker = [&](const WalkGaits& walk) { return std::make_unique<WalkingRobot>(options.type, walk); };
  else
    setup.walker = [robot = findMechanism(options.robot)](const WalkGaits& walk) {
      return std::make_unique<ServoWalker>(robot, walk);
    };
  const std::string heading =
      fmt::format("Walk of the {}, found by bin/optimizewalk.",
                  options.robot.empty() ? "league's robot " + setup.robot : setup.robot);
  const auto write = [&](const WalkGaits& walk) {
    writeFile(options.output, walkFile(walk, common, heading));
  };
  if (options.tryOnly) {
    const std::unique_ptr<Walker> robot = setup.walker(gaits);
    for (const std::string& name : options.tasks) {
      const TrialResult r = tryWalk(*robot, gaits, taskOf(name), setup.trial);
      say(fmt::format("{}, {}: speed {:.3f}, falls {:.3f}, drift {:.3f}", name, setup.robot, r.speed, r.falls,
                      r.drift));
    }
    return;
  }
  if (options.choose) {
    const auto withOver = [&](const std::string& folder) {
      const ConfigFile whole("walking", {"config", folder, options.over});
      WalkGaits walk = readWalkGaits(whole.root());
      whole.checkUnknown();
      return walk;
    };
    // A mistake in it is told before the minutes of choosing, not after them.
    if (!options.over.empty()) withOver(options.from);
    chooseAll(options, gaits, write);
    if (!options.over.empty()) write(withOver(std::filesystem::path(options.output).parent_path().string()));
    return;
  }
  for (const std::string& name : options.tasks) {
    setup.task = taskOf(name);
    gaits = train(gaits, setup, [&](const std::string& line, const WalkGaits& best) {
      say(line);
      write(best);
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  TrainingSetup& setup = options.setup;
  CLI::App app(
      "Finds the walk of a robot type in the simulator with CMA-ES: parameters at full speed in each "
      "direction, then "
      "speeds and feedback for any mixture, and the recovery from pushes.");
  app.add_option("--type", options.type, "robot type 0..4")->check(CLI::Range(0, 4))->capture_default_str();
  app.add_option("--robot", options.robot,
                 "instead of a type: a robot with position servos, by the name of its file in config/robots");
  app.add_option("--task", options.tasks,
                 "what is searched for, in this order: forward, backward, sideways, turn, mixture, push")
      ->check(CLI::IsMember(std::vector<std::string>{taskNames.begin(), taskNames.end()}))
      ->capture_default_str();
  app.add_option("--generations", setup.generations, "of each search")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--population", setup.population, "candidates of a generation")
      ->check(CLI::Range(4, 10000))
      ->capture_default_str();
  app.add_option("--tries", setup.trial.tries, "of each candidate")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--seconds", setup.trial.seconds, "of one try")
      ->check(CLI::Range(2.0, 600.0))
      ->capture_default_str();
  app.add_option("--push", setup.trial.push,
                 "greatest change of velocity by a push, one a second, for the task push one a try [m/s]")
      ->check(CLI::Range(0.0, 3.0))
      ->capture_default_str();
  app.add_option("--sigma", setup.sigma,
                 "how far from the start the first generation lies, in sensible steps")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  app.add_option("--only", setup.only,
                 "names of the parameters that are searched; default: all of the task's");
  app.add_option("--seed", setup.seed, "the same seed repeats the search")->capture_default_str();
  app.add_option("--from", options.from,
                 "folder of the walking.yaml to begin with; default: the type's in config/");
  app.add_flag("--anew", options.anew, "begins with the same parameters in all directions");
  app.add_option("--corners-of", options.cornersOf, "begins with the directions found for another type")
      ->check(CLI::Range(0, 4));
  CLI::Option* choose = app.add_flag(
      "--choose", options.choose,
      "cuts the mixture and each sprint, that of the file and that of the search, to what goes through "
      "minutes of tries without a fall, and takes the fastest");
  app.add_option("--search", options.searched,
                 "with --choose: those of the tasks whose sprints are searched; the others are only cut")
      ->check(CLI::IsMember(std::vector<std::string>{taskNames.begin(), taskNames.end()}))
      ->needs(choose);
  app.add_option("--choice-seed", options.choice.seed, "of those tries")
      ->needs(choose)
      ->capture_default_str();
  app.add_option("--over", options.over, "folder of a walking.yaml that is put over what was chosen")
      ->check(CLI::ExistingDirectory)
      ->needs(choose);
  app.add_flag("--try", options.tryOnly, "only tells how the walk does at the tasks, and writes nothing");
  app.add_option("--output", options.output, "file to write; default: the type's in config/");
  app.footer(
      "Run it from the project's folder. scripts/optimise_walks.sh repeats the search for all types.\n"
      "Example: bin/optimizewalk --type 3 --task forward --generations 50");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "optimizewalk: {}; see optimizewalk --help\n", error.what());
    return 2;
  }
  if (options.from.empty()) options.from = folderOf(options);
  if (options.output.empty()) options.output = folderOf(options) + "/walking.yaml";
  if (!options.over.empty() && std::filesystem::path(options.output).filename() != "walking.yaml") {
    fmt::print(stderr, "optimizewalk: with --over the output is called walking.yaml, not '{}'\n",
               options.output);
    return 2;
  }
  try {
    run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "optimizewalk: {}\n", error.what());
    return 2;
  }
  return 0;
}
