#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/CommandLine.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "framework/Controller.h"
#include "framework/CrashLog.h"
#include "framework/DrawingNames.h"
#include "framework/GraphWriter.h"
#include "framework/GuardedMain.h"
#include "framework/LogBuffer.h"
#include "framework/ParameterPage.h"
#include "framework/Platform.h"
#include "framework/TimingPlugin.h"
#include "framework/WriteFile.h"
#include "modules/behavior/MotionPlayer.h"
#include "modules/evaluation/DecisionRecorder.h"
#include "modules/evaluation/OutputProblems.h"
#include "modules/infrastructure/AgentLog.h"
#include "modules/infrastructure/CognitionConfigLoader.h"
#include "modules/infrastructure/DebugModule.h"
#include "modules/infrastructure/StatusReport.h"
#include "pages/AgentPage.h"
#include "robot/JointStream.h"

// bin/agent: one robot, on the platform that the command line names.

namespace {

using namespace plumbline;

constexpr const char* defaultPlatform = "simspark";
constexpr int faultStatus = 1;  // not a mistake of the user: a server that went away

struct Options {
  std::string platform = defaultPlatform, config, modules, field, graph, stats, motion;
  std::string decisions, crashLog = "crash.log";
  std::shared_ptr<DebugOptions> debug = std::make_shared<DebugOptions>();
  AgentLogOptions log;
  std::vector<std::string> drawings;
  pages::PageServer::Config web{.port = pages::AgentPage::standardPort};
  bool debugs = false, serves = false;
  bool motionOnce = false, status = false, timing = false, verbose = false, parameters = false;
};

std::string drawingProblem(const std::string& name) {
  try {
    chosenDrawings({name});
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

void declare(CommandLine& app, Options& options, Platform& platform) {
  std::string names;
  for (const std::string& name : Platforms::names()) names += (names.empty() ? "" : ", ") + name;
  app.option("--platform", options.platform,
             "what the agent runs on, of: " + names + "; each has options of its own, see --help with it")
      .showDefault();
  platform.declareOptions(app);
  const CommandOption motion = app.option(
      "--motion", options.motion, "play this motion of config/motions again and again instead of soccer");
  app.flag("--once", options.motionOnce, "with --motion: once, then end").needs(motion);
  app.option("--config", options.config, "folder of the configuration").showDefault();
  app.option("--modules", options.modules,
             "modules.cfg; default: platforms/NAME/modules.cfg in the configuration's folder");
  app.option("--field", options.field,
             "file with the sizes of the field; default: field.yaml in the configuration's folder");
  app.option("--graph", options.graph,
             "draw the module graph to FILE (.svg, .pdf, .png or .dot) and end; with --timing at the end of "
             "the run, with what each module cost");
  app.flag("--parameters", options.parameters, "print a page of all parameters of all modules and end");
  app.option(
      "--stats", options.stats,
      "write cycles, CPU per cycle, and cycles late by the clock or by their CPU to FILE as JSON at the end");
  app.flag("--timing", options.timing, "print a table of the time each module took at the end");
  const CommandOption debug = app.option("--debug", options.debug->server.port,
                                         "open the debug port for bin/rdb; 0: a free one, which is printed")
                                  .valueOptional()
                                  .showDefault(std::to_string(inspect::DebugServerOptions::standardPort))
                                  .portOrFree();
  debug.notes(options.debugs);
  app.option("--debug-address", options.debug->server.address,
             "with --debug: where others may reach it; needs --debug-token")
      .needs(debug)
      .showDefault();
  app.option("--debug-token", options.debug->server.token,
             "with --debug: the token that clients must send first")
      .needs(debug);
  declareLogOptions(app, options.log);
  app.option("--decisions", options.decisions,
             "write the striker's decisions and what it decided against into FOLDER/SIDE-NUMBER.csv, for "
             "bin/webmonitor --summary");
  app.option("--draw", options.drawings,
             "show these drawings in the viewer from the start: names separated by commas, of drawings "
             "(BallLocator:ball), modules (BallLocator) or groups (team, belief)")
      .byCommas()
      .oneValueEach()
      .check(drawingProblem);
  app.option("--drawing-port", options.debug->viewer.port,
             "UDP port of the viewer (RoboViz, bin/webmonitor) in which drawings that are switched on appear")
      .port()
      .showDefault();
  app.option("--drawing-address", options.debug->viewer.address, "where that viewer runs").showDefault();
  const CommandOption web =
      app.option("--web", options.web.port,
                 "serve a page to look into the agent; 0: a free port, which is printed")
          .valueOptional()
          .showDefault(std::to_string(pages::AgentPage::standardPort))
          .portOrFree();
  web.notes(options.serves);
  app.option("--web-address", options.web.address, "with --web: where others may reach it; needs --web-token")
      .needs(web)
      .showDefault();
  app.option("--web-token", options.web.token, "with --web: the page opens with ?token=TOKEN only")
      .needs(web);
  app.flag("-v,--verbose", options.verbose, "print every step of every cycle and all log messages");
  app.option("--crash-log", options.crashLog, "file written if the agent dies by a signal").showDefault();
  app.flag("--status", options.status, "print a line per second: the robot's estimates and what it does");
  app.footer(
      "Examples:\n" + platform.examples() +
      "  bin/agent --graph graph.svg                              draw the module graph\n"
      "  bin/agent --start-simulator --draw team,belief           show roles, ways and beliefs in a viewer\n"
      "  bin/agent --start-simulator --log game                   record all that modules know\n"
      "  bin/agent --replay game --log again                      the modules once more, on what was "
      "recorded");
}

void writeStats(const Controller& controller, const std::string& path) {
  nlohmann::json json;
  if (const TimingPlugin* timing = controller.timing()) {
    double cpu = 0;
    for (const ThreadPlan& thread : controller.threads())
      if (const TimingPlugin* other = controller.timing(thread.name)) cpu += other->cpu().total();
    const auto cycles = static_cast<double>(std::max<std::uint64_t>(1, timing->cpu().count()));
    json["cycles"] = timing->cpu().count();
    json["cpu_us_per_cycle"] = 1e6 * cpu / cycles;
    json["cpu_us_p99"] = 1e6 * timing->cpu().percentile(0.99);
    json["cpu_us_max"] = 1e6 * timing->largestCpu();
    json["first_cycle_cpu_us"] = 1e6 * timing->firstCpu();
    json["busy_us_p99"] = 1e6 * timing->busy().percentile(0.99);
    json["late_cycles"] = timing->lateBusy();
    json["late_cycles_cpu"] = timing->lateCpu();
  }
  writeFile(path, json.dump(2) + "\n");
}

/// A modules.cfg in which the module MotionPlayer replaces the one that provides the MotionRequest.
ModulesConfig withMotionPlayer(const std::string& path) {
  ModulesConfig modules = readModulesConfig(path);
  bool replaced = false;
  const auto isThread = [&modules](const std::string& name) {
    return std::ranges::any_of(modules.threads, [&](const ThreadConfig& t) { return t.name == name; });
  };
  for (ThreadConfig& thread : modules.threads)
    for (ModulesConfigLine& line : thread.lines) {
      if (line.representation != "MotionRequest" || isThread(line.provider)) continue;
      line.provider = "MotionPlayer";
      replaced = true;
    }
  if (!replaced) throw ConfigurationError(path + ": nothing provides MotionRequest, so --motion cannot work");
  return modules;
}

void requireModule(const Controller& controller, const std::string& modulesConfig, const std::string& name,
                   const std::string& what) {
  const bool runs = std::ranges::any_of(controller.threads(), [&](const ThreadPlan& thread) {
    return std::ranges::any_of(thread.modules,
                               [&](const ModulePlan& m) { return m.loader->description().name == name; });
  });
  if (!runs)
    throw ConfigurationError(fmt::format(
        "{}: this agent {}: no line has the module {}; was the file cut off?", modulesConfig, what, name));
}

bool hasLog(const Controller& controller) {
  return std::ranges::any_of(controller.threads(), [](const ThreadPlan& thread) {
    return std::ranges::any_of(thread.specials, [](const SpecialPlan& s) { return s.name == "log"; });
  });
}

// A truncated modules.cfg is still a valid graph, but of an agent that does nothing.
void requirePlatform(const Controller& controller, const Platform& platform,
                     const std::string& modulesConfig) {
  for (const auto& [name, what] : platform.neededModules())
    requireModule(controller, modulesConfig, name, what);
}

void notify(const std::string& line) { fmt::print(stderr, "agent: {}\n", line); }

int runAgent(const Options& options, const Platform& platform, std::shared_ptr<OutputProblems> problems) {
  if (options.parameters) {
    fmt::print("{}", parameterPage());
    return 0;
  }
  useConfigFolder(options.config);
  platform.check();
  ControllerOptions setup;
  setup.modulesConfig = options.modules.empty()
                            ? options.config + "/platforms/" + options.platform + "/modules.cfg"
                            : options.modules;
  setup.configDirectories = {options.config};
  for (const std::string& folder : platform.configFolders(options.config))
    setup.configDirectories.push_back(folder);
  ModulesConfig modules =
      options.motion.empty() ? readModulesConfig(setup.modulesConfig) : withMotionPlayer(setup.modulesConfig);
  if (options.log.replays()) modules = modulesOnLog(std::move(modules), options.log, options.platform);
  Controller controller(setup, modules);
  controller.stop().catchSignals();  // what is made from here on is ended in order
  if (!options.graph.empty() && !options.timing) {
    writeGraph(controller.threads(), options.graph);
    return 0;
  }
  if (!options.log.replays()) requirePlatform(controller, platform, setup.modulesConfig);
  const CrashLog crashLog(options.crashLog);
  LogBuffer::instance().setVerbose(options.verbose);
  platform.addObjects(controller.objects(), notify);
  if (const auto* robot = controller.objects().find<RobotModel>()) streamJointsOf(*robot);
  controller.objects().set(std::move(problems));
  controller.objects().set(std::make_shared<MotionToPlay>(MotionToPlay{options.motion, options.motionOnce}));
  controller.objects().set(std::make_shared<FieldChoice>(FieldChoice{options.field}));
  controller.objects().set(std::make_shared<StatusOptions>(StatusOptions{options.status}));
  if (!options.decisions.empty()) {
    requireModule(controller, setup.modulesConfig, "DecisionRecorder", "writes no decisions");
    controller.objects().set(std::make_shared<DecisionOptions>(DecisionOptions{options.decisions}));
  }
  if (options.debugs || options.serves || !options.drawings.empty()) {
    requireModule(controller, setup.modulesConfig, "DebugModule", "has no debug port");
    options.debug->drawings = chosenDrawings(options.drawings);
    options.debug->notify = notify;
    options.debug->server.listens = options.debugs;
    if (options.serves)
      options.debug->serve = [&options](inspect::DebugServer& server) {
        auto page = std::make_shared<pages::AgentPage>(options.web, server);
        notify("page " + page->address());
        return page;
      };
    controller.objects().set(options.debug);
  }
  if (options.log.records() && !hasLog(controller))
    throw ConfigurationError(setup.modulesConfig +
                             ": no line has the special module log, so nothing is recorded");
  // A person who watches a log in a page wants to see its beginning.
  AgentLogOptions logged = options.log;
  if (options.serves && !logged.records()) logged.replayed.paused = true;
  const auto log = makeLog(logged, controller, setup.configDirectories, notify);
  controller.objects().set(log);
  int status = controller.run();
  if (log->recorder) {
    log->recorder->finish();
    if (log->recorder->endsEarly() && status == 0) return ConfigurationError::exitCode;  // which it has said
  }
  if (!options.stats.empty()) writeStats(controller, options.stats);
  if (options.timing) fmt::print("{}", controller.timingReport());
  if (!options.graph.empty()) writeGraph(controller.threads(), options.graph, controller.moduleTimes());
  if (status != 0) fmt::print(stderr, "agent: {}\n", controller.stop().reason());
  return status;
}

int runProgram(int argc, char** argv) {
  Options options;
  options.config = configFolder();
  const auto platform = Platforms::make(chosenPlatform(argc, argv, defaultPlatform));
  CommandLine app("A humanoid robot that plays soccer, on one of the platforms; simspark is the 3D league.");
  declare(app, options, *platform);
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  const auto problems = std::make_shared<OutputProblems>(notify);
  const int status = runAgent(options, *platform, problems);
  // Only now: some modules write as they end.
  return status == 0 && problems->any() ? ConfigurationError::exitCode : status;
}

}  // namespace

int main(int argc, char** argv) {
  return plumbline::guardedMain("agent", runProgram, argc, argv, faultStatus);
}
