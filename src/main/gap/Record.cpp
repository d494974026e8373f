// bin/gap record: plays excitation programs on a simulated robot, or on one of a SimSpark server, and writes
// runs.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>

#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "gap/diagnosis/ExplanationFile.h"
#include "gap/record/EngineRecording.h"
#include "gap/record/ExcitationFile.h"
#include "gap/record/Secret.h"
#include "gap/record/SimsparkRecording.h"
#include "gap/record/SimulatedRecording.h"
#include "gap/record/WalkRecording.h"
#include "gap/run/RunFile.h"
#include "main/gap/Commands.h"
#include "main/gap/RecordingsFolder.h"
#include "main/gap/RobotOption.h"
#include "robot/MechanismCheck.h"
#include "servo/RobotSimulation.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::gap {

namespace {

namespace fs = std::filesystem;

constexpr const char* ownEngine = "own";

struct RecordOptions {
  std::string robot = "nao_v5", battery, effects, output, engine = ownEngine;
  SimsparkRecordingOptions simspark;
  std::vector<std::string> programs;
  std::uint64_t seed = 1, programSeed = 0, secret = 0;
  bool hasSecret = false, noisy = true, truth = false, force = false;
};

/// A program to play, and which recording it repeats.
struct Item {
  Excitation program;
  std::string name, repeatOf;
};

Excitation programOf(const std::string& given, const Mechanism& robot, std::uint64_t seed) {
  if (given.find('/') != std::string::npos || given.ends_with(".yaml"))
    return readExcitation(given, robot, seed);
  return findExcitation(given, robot, seed);
}

std::vector<Item> itemsOf(const RecordOptions& options, const Mechanism& robot) {
  std::vector<Item> items;
  // What is asked for again is recorded as a repeat.
  std::map<std::string, int> asked;
  const auto add = [&](const std::string& program) {
    Excitation e = programOf(program, robot, options.programSeed);
    const std::string name = e.name;
    const int before = asked[program]++;
    const std::string again = before > 1 ? "_again_" + std::to_string(before) : "_again";
    items.push_back({std::move(e), before > 0 ? name + again : name, before > 0 ? name : ""});
  };
  for (const std::string& program : options.programs) add(program);
  if (options.battery == "hang" || options.battery == "all") {
    for (const std::string& program : hangingBattery()) add(program);
    add(hangingBattery().front());
  }
  if (options.battery == "stand" || options.battery == "all") {
    for (const std::string& program : floatingBaseBattery()) add(program);
    add(floatingBaseBattery().front());
  }
  return items;
}

/// "simspark" with a type means a robot of a SimSpark server.
bool onServer(const RecordOptions& options) { return options.robot == "simspark"; }

Run recordOne(const RecordOptions& options, const Mechanism& robot, const Item& item,
              const SimulatedRecordingOptions& recording) {
  const bool own = options.engine == ownEngine;
  // The project's own dynamics have no closed loop.
  if (item.program.walk)
    return recordWalk(own ? servo::RobotSimulations::usual : options.engine, robot, item.program, recording);
  if (!onServer(options))
    return own ? recordSimulated(robot, item.program, recording)
               : recordInEngine(options.engine, robot, item.program, recording);
  SimsparkRecording recorded = recordSimspark(robot, item.program, options.simspark);
  if (recorded.lostCycles > 0)
    std::fprintf(stderr, "gap: %s: %zu cycles were lost; the run has gaps there\n", item.name.c_str(),
                 recorded.lostCycles);
  if (recorded.fell) std::fprintf(stderr, "gap: %s: the robot fell over\n", item.name.c_str());
  return std::move(recorded.run);
}

void checkWalks(const RecordOptions& options, const std::vector<Item>& items) {
  for (const Item& item : items)
    if (item.program.walk && (onServer(options) || options.hasSecret))
      throw std::invalid_argument(item.name + " is walked by a robot simulated here, without --secret");
}

void checkOptions(const RecordOptions& options) {
  servo::RobotSimulations::require(options.engine, {ownEngine});
  if (!onServer(options)) return;
  if (!options.effects.empty() || options.hasSecret)
    throw std::invalid_argument(
        "a robot of a server has the effects that its server gives it: start bin/simulator --effects FILE");
  if (options.engine != ownEngine || options.truth)
    throw std::invalid_argument(
        "--engine and --truth are for robots simulated here, not for --robot simspark");
}

void record(const RecordOptions& options) {
  if (options.programs.empty() == options.battery.empty())
    throw std::invalid_argument("record needs --program or --battery, one of them");
  checkOptions(options);
  const Mechanism robot =
      robotOf(onServer(options) ? simsparkRobotName(options.simspark.type) : options.robot, "");
  requirePositionServos(robot);
  const std::vector<Item> items = itemsOf(options, robot);
  checkWalks(options, items);
  const bool single = options.battery.empty() && items.size() == 1;
  RecordingsFolder output(options.output, options.force);

  SimulatedRecordingOptions recording;
  recording.noisy = options.noisy;
  recording.truth = options.truth;
  if (!options.effects.empty()) recording.effects = causesOf(simulation::readEffects(options.effects), robot);
  std::string sealed;
  if (options.hasSecret) {
    std::vector<Excitation> programs;
    for (const Item& item : items)
      if (item.repeatOf.empty()) programs.push_back(item.program);
    recording.effects = {drawSecret(robot, programs, options.secret)};
    sealed = seal(simulation::effectsText(settingsOf(recording.effects), robot.name), options.secret) + "\n";
  }
  const fs::path folder(output.partial());
  std::size_t done = 0;
  for (const Item& item : items) {
    StopSignal::throwIfCaught();
    recording.seed = options.seed * 1000 + done;
    Run run = recordOne(options, robot, item, recording);
    run.repeatOf = item.repeatOf;
    WriteRunOptions writing;
    writing.digits = 5;
    writeRun(run, (single ? folder : folder / item.name).string(), writing);
    std::printf("%zu/%zu %s: %.1f s\n", ++done, items.size(), item.name.c_str(), run.duration());
    std::fflush(stdout);
  }
  if (!sealed.empty()) writeFile((folder / "SECRET").string(), sealed);
  output.putInPlace();
  std::printf("Written to %s%s\n", options.output.c_str(),
              sealed.empty() ? ""
                             : ("; the effect of this robot is sealed in it: bin/gap reveal " +
                                options.output + " opens it")
                                   .c_str());
}

}  // namespace

void addRecord(CommandLine& app) {
  auto options = std::make_shared<RecordOptions>();
  CommandLine command = app.command("record", "Plays excitation programs on a robot and writes runs");
  command
      .option("--robot", options->robot,
              "Simulated here: a name in config/robots, URDF or JSON file; simspark: a robot of a "
              "SimSpark server")
      .showDefault();
  command
      .option("--engine", options->engine,
              fmt::format("own: the diagnosis' own dynamics; or another engine of this program: {}",
                          fmt::join(servo::RobotSimulations::names(), ", ")))
      .showDefault();
  command.option("--host", options->simspark.host, "Of the SimSpark server").showDefault();
  command.option("--port", options->simspark.port, "Its port for agents").port().showDefault();
  command.option("--type", options->simspark.type, "Of the SimSpark robot")
      .range(0, maxSimsparkTypes - 1)
      .showDefault();
  command.option(
      "--program", options->programs,
      std::string("Programs: names in config/excitation, or files; several make several runs, one named "
                  "again a repeat. Walks are walked in ") +
          servo::RobotSimulations::usual + ", or in --engine");
  command.option("--battery", options->battery, "A standard set of programs, with a repeat")
      .oneOf({"hang", "stand", "all"});
  command.option("--effects", options->effects, "The robot has these effects: doc/reference/effects-file.md");
  const CommandOption secret = command.option(
      "--secret", options->secret, "The robot has one effect that this seed draws, sealed in SECRET");
  secret.excludes("--effects");
  command.option("--seed", options->seed, "Of the sensors' noise; same seed, same bytes").showDefault();
  command
      .option("--program-seed", options->programSeed,
              "Changes the random parts of the programs; 0: as in their files")
      .showDefault();
  command.flag("!--no-noise", options->noisy, "Sensors without noise");
  command.flag("--truth", options->truth, "truth.* columns of a robot on its feet");
  command.option("-o,--output", options->output, "Run folder; for several runs the folder that holds them")
      .required();
  command.flag("--force", options->force, "Replaces existing recordings");
  command.footer(
      "Examples:\n  bin/gap record --battery hang --secret 10 -o runs\n"
      "  bin/gap record --robot so101 --program hang_sweep -o sweep --effects effects.yaml\n"
      "  bin/gap record --battery stand --engine bullet -o standing\n"
      "  bin/simulator --sync & bin/gap record --robot simspark --type 1 --program stand_squat -o squat");
  command.whenChosen([options, secret] {
    options->simspark.stop = [] {
      StopSignal::throwIfCaught();
      return false;
    };
    options->hasSecret = secret.given();
    record(*options);
  });
}

}  // namespace plumbline::gap
