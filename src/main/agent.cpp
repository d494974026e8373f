#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "framework/Controller.h"
#include "framework/CrashLog.h"
#include "framework/GraphWriter.h"
#include "framework/LogBuffer.h"
#include "framework/TimingPlugin.h"
#include "framework/WriteFile.h"
#include "modules/simspark/AgentOptions.h"
#include "robot/RobotModel.h"
#include "simspark/ChildProcess.h"

// bin/agent: one robot of the 3D league.

namespace {

using namespace plumbline;

struct Options {
  std::shared_ptr<AgentOptions> agent = std::make_shared<AgentOptions>();
  std::string config, modules, graph, stats;
  std::string crashLog = "crash.log";
  bool timing = false, verbose = false;
};

// Paths in messages are short if the agent is started from near its folder.
std::string nearPath(const std::filesystem::path& path) {
  std::error_code error;
  const auto shorter = std::filesystem::proximate(path, error);
  return error || shorter.string().starts_with("../../..") ? path.lexically_normal().string()
                                                           : shorter.string();
}

void declare(CLI::App& app, Options& options) {
  AgentOptions& agent = *options.agent;
  app.add_option("--team", agent.team, "team name")->capture_default_str();
  app.add_option("--number", agent.number, "uniform number 1..11, 0: the next free one")
      ->check(CLI::Range(0, 11))
      ->capture_default_str();
  app.add_option("--type", agent.type, "robot type 0..4")->check(CLI::Range(0, 4))->capture_default_str();
  app.add_option("--host", agent.host, "host of the simulator")->capture_default_str();
  app.add_option("--port", agent.port, "its agent port")->check(CLI::Range(1, 65535))->capture_default_str();
  app.add_option("--monitor-port", agent.monitorPort, "its monitor port, for trainer commands")
      ->check(CLI::Range(1, 65535))
      ->capture_default_str();
  app.add_flag("--start-simulator", agent.startSimulator,
               "start a simulator on free ports and restart it when it dies");
  app.add_option("--simulator-option", agent.simulatorOptions,
                 "an option for that simulator; repeat for more")
      ->allow_extra_args(false);
  app.add_option("--config", options.config, "folder of the configuration")->capture_default_str();
  app.add_option("--modules", options.modules, "modules.cfg; default: the one in the configuration's folder");
  app.add_option("--graph", options.graph,
                 "draw the module graph to FILE (.svg, .pdf, .png or .dot) and end");
  app.add_option("--stats", options.stats, "write cycles and CPU per cycle to FILE as JSON at the end");
  app.add_flag("--timing", options.timing, "print a table of the time each module took at the end");
  app.add_flag("-v,--verbose", options.verbose, "print every step of every cycle and all log messages");
  app.add_option("--crash-log", options.crashLog, "file written if the agent dies by a signal")
      ->capture_default_str();
  app.add_flag("--status", agent.status, "print a line per second: what the robot believes and does");
  app.footer(
      "Examples:\n"
      "  bin/agent --team Plumbline --number 1 --type 0           play on a server at port 3100\n"
      "  bin/agent --start-simulator --status                     start a simulator, too\n"
      "  bin/agent --graph graph.svg                              draw the module graph");
}

void writeStats(const Controller& controller, const std::string& path) {
  const TimingPlugin* timing = controller.timing();
  nlohmann::json json;
  if (timing) {
    json["cycles"] = timing->cpu().count();
    json["cpu_us_per_cycle"] = timing->cpu().mean() * 1e6;
  }
  writeFile(path, json.dump(2) + "\n");
}

int runAgent(const Options& options) {
  ControllerOptions setup;
  setup.modulesConfig = options.modules.empty() ? options.config + "/modules.cfg" : options.modules;
  setup.configDirectories = {options.config,
                             options.config + "/robots/type" + std::to_string(options.agent->type)};
  Controller controller(setup);
  if (!options.graph.empty()) {
    writeGraph(controller.threads(), options.graph);
    return 0;
  }
  const CrashLog crashLog(options.crashLog);
  LogBuffer::instance().setVerbose(options.verbose);
  controller.objects().set(options.agent);
  controller.objects().set(std::make_shared<RobotModel>(simsparkRobot(options.agent->type)));
  controller.stop().catchSignals();
  const int status = controller.run();
  if (!options.stats.empty()) writeStats(controller, options.stats);
  if (options.timing) fmt::print("{}", controller.timingReport());
  if (status != 0) fmt::print(stderr, "agent: {}\n", controller.stop().reason());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.config = nearPath(std::filesystem::path(simspark::programFolder()) / ".." / "config");
  CLI::App app("A robot of the RoboCup 3D soccer simulation league.");
  declare(app, options);
  try {
    app.parse(argc, argv);
    return runAgent(options);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "agent: {}; see agent --help\n", error.what());
  } catch (const ConfigurationError& error) {
    fmt::print(stderr, "agent: {}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "agent: {}\n", error.what());
    return 1;
  }
  return ConfigurationError::exitCode;
}
