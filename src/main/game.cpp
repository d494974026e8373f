#include <fmt/format.h>

#include <cstdio>

#include "framework/CommandLine.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "game/GameRun.h"
#include "game/OutputFolder.h"
#include "simspark/LeagueRobots.h"
#include "simulation/physics/Physics.h"

// bin/game: a robot alone on the field until it scores.

namespace {

int runProgram(int argc, char** argv) {
  using namespace plumbline;
  game::GameOptions options;
  CommandLine app(
      "One robot, a ball and a goal: starts the embedded simulator and an agent and watches them.");
  app.option("--type", options.type, "robot type: N of config/robots/simspark_typeN.json")
      .range(0, maxSimsparkTypes - 1)
      .showDefault();
  app.option("--seed", options.seed, "the same seed repeats the run, from 1")
      .range(1u, 4000000000u)
      .showDefault();
  app.option("--limit", options.limit, "simulated seconds it may take").range(1.0, 36000.0).showDefault();
  app.option("--engine", options.engine, "physics of the embedded simulator")
      .oneOf(simulation::physicsEngines())
      .showDefault();
  app.option("--field", options.field, "file with the sizes of the field, as config/field.yaml")
      .existingFile();
  app.flag("--realtime", options.realtime, "in real time instead of as fast as possible");
  const CommandOption web = app.flag(
      "--web", options.web, "shows it on a page, whose address is printed; `make web` builds the page");
  app.flag("--stay", options.stay, "keeps the page open on the last picture until Ctrl-C").needs(web);
  options.output = game::defaultOutput();
  app.option("--output", options.output, "folder for summary.json, track.svg and the logs").showDefault();
  app.option("--host", options.host, "play on a server that runs already, e.g. the league's");
  app.option("--port", options.port, "its agent port").port().showDefault();
  app.option("--monitor-port", options.monitorPort, "its monitor port").port().showDefault();
  app.option("--agent-option", options.agentOptions, "passed to bin/agent; repeat for more").oneValueEach();
  app.option("--simulator-option", options.simulatorOptions,
             "passed to bin/simulator, e.g. --simulator-option=--no-bouncing-stops; repeat for more")
      .oneValueEach();
  app.footer(
      "Exit status: 0 after a goal, 1 without one, 2 for bad options and what else keeps it from playing, "
      "130 after\n"
      "Ctrl-C in the game.\n"
      "Examples:\n"
      "  bin/game --type 4 --seed 7\n"
      "  bin/game --field small.yaml\n"
      "  bin/game --host 127.0.0.1 --port 3100 --monitor-port 3200");
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  if (options.agentOptions.empty()) simsparkRobot(options.type);  // else it may have a folder of its own
  StopSignal stop;
  stop.catchSignals();
  const game::Summary summary = game::GameRun(options).play(stop);
  if (!summary.over) {
    fmt::print(stderr, "game: interrupted\n");
    return 130;
  }
  if (summary.goal)
    fmt::print("goal after {:.2f} s, {} fall{}; {}/summary.json, {}/track.svg\n", summary.goalTime,
               summary.falls, summary.falls == 1 ? "" : "s", options.output, options.output);
  else
    fmt::print("no goal within {:.0f} s, {} fall{}; see {}\n", options.limit, summary.falls,
               summary.falls == 1 ? "" : "s", options.output);
  return summary.goal ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("game", runProgram, argc, argv); }
