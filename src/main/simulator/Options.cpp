#include "Options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "field/FieldFile.h"
#include "field/TeamSize.h"
#include "framework/CommandLine.h"
#include "framework/Loopback.h"
#include "simspark/NumberFormat.h"
#include "simulation/effects/EffectTable.h"
#include "simulation/physics/Physics.h"
#include "simulation/referee/RulesFile.h"
#include "simulation/referee/rules/SelfCollision.h"

namespace plumbline::simulation {

namespace {

/// Accepts a number for which `good` holds; else says what is wanted.
OptionCheck number(const std::string& wanted, bool (*good)(double)) {
  return [wanted, good](const std::string& text) {
    const auto value = simspark::parseNumber(text);
    return value && good(*value) ? std::string() : "'" + text + "' is not " + wanted;
  };
}

bool isWhole(double value) { return value == std::floor(value); }

const OptionCheck aPort =
    number("a port, 0 to 65535", [](double v) { return isWhole(v) && v >= 0 && v <= 65535; });
const OptionCheck aDuration = number("a time above 0 s", [](double v) { return v > 0; });
const OptionCheck aPatience = number("a time of 0 s or more", [](double v) { return v >= 0; });

/// The options as given, before they are combined.
struct Given {
  std::string bind = "127.0.0.1", token, rulesFile, effectsFile, fieldFile;
  std::uint64_t seed = 0;
  bool realTime = false, frozenLimbs = true, openAgents = false, printRules = false;
  double monitorStep = 0.04, maxSeconds = 0, kickOffAfter = 0, halfTime = 300;
  int waitForAgents = 0, replayType = 0, webPort = -1, drawingPort = 0, fieldPort = 0;
};

void complete(Options& options, const Given& given, const CommandLine& app) {
  ServerConfig& server = options.server;
  const bool open = !isLoopbackAddress(given.bind);
  if (open && given.token.empty())
    throw std::runtime_error("--bind " + given.bind + " opens the ports to others: set a --token");
  const auto set = [&app](const char* name) { return app.given(name); };
  server.agents.address = server.monitors.address = given.bind;
  server.monitors.token = given.token;
  // On this machine teams that cannot send one play, as on the league's server.
  if (open && !given.openAgents) server.agents.token = given.token;
  server.monitors.interval =
      std::max(1, static_cast<int>(std::lround(given.monitorStep / server.simulation.world.stepSeconds)));
  server.realTime = set("--realtime") ? given.realTime : !server.agents.sync;
  server.waitForAgents = set("--wait-agents") ? given.waitForAgents : server.realTime ? 0 : 1;
  if (set("--field-port") || (server.monitors.port > 0 && server.monitors.port < 65535)) {
    server.field = {given.bind, set("--field-port") ? given.fieldPort : server.monitors.port + 1,
                    given.token};
    server.fieldOptional = !set("--field-port");
  }
  Rules& rules = server.simulation.rules;
  if (!given.rulesFile.empty()) rules = readRules(given.rulesFile);
  if (!given.fieldFile.empty()) server.simulation.world.field = readFieldFile(given.fieldFile);
  if (!given.effectsFile.empty()) {
    server.simulation.world.effects = readEffects(given.effectsFile);
    checkEffects(server.simulation.world.effects);
  }
  if (set("--frozen-limbs")) rules.of<SelfCollision>().on = given.frozenLimbs;
  if (set("--half-time")) rules.time.half = given.halfTime;
  if (set("--max-seconds")) server.maxSeconds = given.maxSeconds;
  if (set("--kickoff-after")) rules.kickOff.after = given.kickOffAfter;
  if (set("--web")) {
    options.anyWebPort = given.webPort < 0;
    options.webPort = options.anyWebPort ? 8080 : given.webPort;
  }
  if (!options.recordFile.empty() && !options.webPort)
    throw std::runtime_error("--record records what the page shows: give --web as well");
  if (set("--drawing-port")) options.drawingPort = given.drawingPort;
  if (options.drawingPort && !options.webPort)
    throw std::runtime_error("--drawing-port takes what the page shows: give --web as well");
  if (set("--type")) options.replayType = given.replayType;
  server.simulation.seed = given.seed != 0 ? given.seed : std::random_device()();
}

/// Accidents of the league's server; each name says what the option switches off.
void addSwitches(CommandLine& app, WorldConfig& world, bool& frozenLimbs) {
  const auto add = [&app](const std::string& name, bool& on, const std::string& meaning) {
    app.flag("--" + name + ",!--no-" + name, on, meaning + " [on]");
  };
  add("bouncing-stops", world.bouncingJointStops, "A joint that runs into its stop comes back as fast");
  add("sleeping-robots", world.sleepingRobots, "A body that is slow for ten cycles sleeps until commanded");
  add("frozen-limbs", frozenLimbs, "A limb that collides with its own robot does not move for a second");
  add("action-delay", world.actionDelay, "An answer shows a message later than it could");
  add("endless-friction", world.endlessFriction, "Friction without Coulomb's limit; off: coefficient 1");
  add("lasting-commands", world.lastingCommands, "A joint's speed is kept until changed; off: for a cycle");
}

}  // namespace

Options parseOptions(int argc, char** argv) {
  Options options;
  Given given;
  ServerConfig& server = options.server;
  CommandLine app("Embedded simulator: SimSpark's protocol on an agent port and a monitor port.",
                  "simulator");
  app.option("--port", server.agents.port, "Agent port; 0: a free one [3100]").check(aPort);
  app.option("--monitor-port", server.monitors.port, "Monitor port; 0: a free one [3200]").check(aPort);
  app.option("--field-port", given.fieldPort,
             "Port of bin/simplemonitor; 0: a free one [the monitor port + 1; none if that is 0]")
      .check(aPort);
  app.option("--bind", given.bind, "Address to listen on [127.0.0.1]; any but loopback needs --token");
  app.option("--token", given.token,
             "Monitors must first send (token TOKEN); agents, too, if --bind is not loopback");
  app.flag("--agents-without-token", given.openAgents,
           "With --bind: agents need no token, for teams that cannot send one");
  app.option("--ports-file", options.portsFile,
             "Write {\"agent\": PORT, \"monitor\": PORT} here once both are open");
  app.option("--seed", given.seed, "Same seed, same bytes; 0: one by chance, which is printed [0]")
      .check(
          number("a whole number, 0 to 2^53", [](double v) { return isWhole(v) && v >= 0 && v <= 0x1p53; }));
  app.flag("--sync", server.agents.sync, "Wait for (syn) of every agent in each cycle");
  app.flag("--realtime,!--no-realtime", given.realTime,
           "50 cycles a second, or as fast as it goes [the first without --sync]");
  app.option("--wait-agents", given.waitForAgents,
             "The clock is stopped until this many agents are connected [0 in real time, else 1]")
      .check(number("a number of agents, 0 to 22",
                    [](double v) { return isWhole(v) && v >= 0 && v <= 2 * teamSize; }));
  app.option("--sync-timeout", server.agents.syncTimeout,
             "Drop an agent that is silent for this many seconds; 0: never [60]")
      .check(aPatience);
  app.option("--max-seconds", given.maxSeconds, "End after so much simulated time").check(aDuration);
  app.option("--kickoff-after", given.kickOffAfter, "Kick off without a trainer after this many seconds")
      .check(aPatience);
  app.option("--rules", given.rulesFile, "Rules that differ from the league's, in the form of --print-rules");
  app.flag("--print-rules", given.printRules, "Print all rules and their numbers as such a file and end");
  app.option(
      "--field", given.fieldFile,
      "Sizes of the field that differ from the league's, as length: 14; doc/reference/parameters.md has all");
  app.option("--effects", given.effectsFile,
             "Robots and ground have these effects, as bin/gap apply writes them");
  app.option("--half-time", given.halfTime, "Length of a half in seconds [300]").check(aDuration);
  app.option("--engine", server.simulation.world.engine,
             fmt::format("Physics engine: {} [ode]", fmt::join(simulation::physicsEngines(), ", ")));
  addSwitches(app, server.simulation.world, given.frozenLimbs);
  app.option("--monitor-step", given.monitorStep, "Seconds between two messages to a monitor [0.04]")
      .check(number("a time of 0.02 to 10 s", [](double v) { return v >= 0.02 && v <= 10; }));
  app.flag("--ground-truth", server.simulation.players.groundTruth,
           "Send every agent the true state as well");
  app.option("--ground-truth-decimals", server.simulation.players.groundTruthDecimals,
             "Digits behind the point of the true state [2]")
      .check(number("0 to 9", [](double v) { return isWhole(v) && v >= 0 && v <= 9; }));
  app.option("--stats", options.statisticsFile, "Write what the run cost here at the end, as JSON");
  app.flag("--die-with-parent", options.dieWithParent, "End when the process that started this one ends");
  app.option("--replay", options.replayFile,
             "Repeat a recording of the league's server, print how well it agrees, end");
  app.option("--type", given.replayType, "Robot type of the recording, if its name does not end with it")
      .check(number("a robot type, from 0", [](double v) { return isWhole(v) && v >= 0 && v <= 9; }));
  app.option("--web", given.webPort,
             "Show the game on a page, on this port; 0: a free one [8080, or a free one if it is in use]")
      .valueOptional()
      .check(aPort);
  app.option("--drawing-port", given.drawingPort,
             "With --web: UDP port of the agents' drawings; 0: a free one [32769, or none if it is in use]")
      .check(aPort);
  app.option("--record", options.recordFile, "With --web: write the match to this file");
  app.flag("-v,--verbose", options.verbose, "Print the time that the run took at the end");
  app.footer(
      "Examples:\n"
      "  bin/simulator --web                          a field with its page; bin/start.sh brings a team\n"
      "  bin/simulator --sync --seed 7                as fast as it goes, the same bytes each time\n"
      "  bin/simulator --web --record match.plm       bin/webmonitor --replay match.plm shows it again\n"
      "  bin/simulator --effects effects.yaml         robots with what bin/gap found");
  options.exitStatus = readCommandLine(app, argc, argv);
  if (!options.exitStatus && given.printRules) {
    fmt::print("{}", rulesText(given.rulesFile.empty() ? Rules() : readRules(given.rulesFile)));
    options.exitStatus = 0;
  }
  if (!options.exitStatus) complete(options, given, app);
  return options;
}

}  // namespace plumbline::simulation
