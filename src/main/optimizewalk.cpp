#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "training/WalkTraining.h"

// bin/optimizewalk: finds the walk of a robot type in the simulator.

int main(int argc, char** argv) {
  using namespace plumbline;
  using namespace plumbline::walking;
  TrainingSetup setup;
  std::vector<std::string> tasks;
  std::string from, output;
  CLI::App app("Finds the walk of a robot type in the simulator with CMA-ES.");
  app.add_option("--type", setup.type, "robot type 0..4")->check(CLI::Range(0, 4))->capture_default_str();
  app.add_option("--task", tasks, "forward, backward, sideways, turn, mixture; in this order");
  app.add_option("--generations", setup.generations)->capture_default_str();
  app.add_option("--population", setup.population)->capture_default_str();
  app.add_option("--tries", setup.trial.tries)->capture_default_str();
  app.add_option("--push", setup.trial.push)->capture_default_str();
  app.add_option("--seconds", setup.trial.seconds)->capture_default_str();
  app.add_option("--sigma", setup.sigma)->capture_default_str();
  app.add_option("--seed", setup.seed)->capture_default_str();
  app.add_option("--from", from, "walking.yaml to begin with");
  app.add_option("--output", output, "file to write; default: that of the type in config/");
  CLI11_PARSE(app, argc, argv);
  if (from.empty()) from = "config/robots/type" + std::to_string(setup.type);
  if (output.empty()) output = "config/robots/type" + std::to_string(setup.type) + "/walking.yaml";
  const ConfigFile file("walking", {"config", from});
  WalkGaits gaits = readWalkGaits(file.root());
  const ConfigFile commonFile("walking", {"config"});
  const WalkParameters common = readWalkGaits(commonFile.root()).base;
  for (const std::string& name : tasks) {
    for (std::size_t i = 0; i < taskNames.size(); ++i)
      if (name == taskNames[i]) setup.task = static_cast<Task>(i);
    gaits = train(gaits, setup, [&](const std::string& line, const WalkGaits& best) {
      std::puts(line.c_str());
      std::fflush(stdout);
      std::ofstream(output + ".new") << walkFile(
          best, common,
          "Walk of the league's robot type " + std::to_string(setup.type) + ", found by bin/optimizewalk.");
      std::filesystem::rename(output + ".new", output);
    });
  }
  return 0;
}
