// bin/simulator: the embedded simulator as a server that speaks SimSpark's protocol.
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <random>
#include <string>

#include "simulation/server/Reports.h"
#include "simulation/server/Server.h"

using namespace plumbline::simulation;

namespace {

constexpr int badInput = 2;
std::atomic<bool> stopRequested = false;

void requestStop(int) { stopRequested = true; }

void handleSignals() {
  struct sigaction action {};
  action.sa_handler = requestStop;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
}

struct Options {
  ServerConfig server;
  std::string portsFile, statisticsFile;
  bool verbose = false, dieWithParent = false;
};

bool isLoopback(const std::string& address) {
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}

/// Throws CLI::ParseError for what CLI11 finds, std::runtime_error for what it does not.
Options parseOptions(int argc, char** argv) {
  Options options;
  ServerConfig& server = options.server;
  CLI::App app("Embedded simulator: SimSpark's protocol on an agent and a monitor port.", "simulator");
  app.set_help_flag("-h,--help", "Print this help and exit");
  std::string bind = "127.0.0.1", token;
  std::uint64_t seed = 0;
  bool realTime = false;
  double monitorStep = 0.04, maxSeconds = 0, kickOffAfter = 0;
  int waitForAgents = 0;
  auto port = CLI::Range(0, 65535);
  app.add_option("--port", server.agents.port, "Agent port; 0: a free one [3100]")->check(port);
  app.add_option("--monitor-port", server.monitors.port, "Monitor port; 0: a free one [3200]")->check(port);
  app.add_option("--bind", bind, "Address to listen on [127.0.0.1]; any but loopback needs --token");
  app.add_option("--token", token, "Monitors must first send (token TOKEN)");
  app.add_option("--ports-file", options.portsFile, "Write {\"agent\": PORT, \"monitor\": PORT} here");
  app.add_option("--seed", seed, "Same seed, same bytes; 0: one by chance [0]");
  app.add_flag("--sync", server.agents.sync, "Wait for (syn) of every agent each cycle");
  auto* realTimeOption = app.add_flag("--realtime,!--no-realtime", realTime,
                                      "50 cycles a second [default without --sync], or as fast as it goes");
  auto* wait = app.add_option("--wait-agents", waitForAgents,
                              "The clock stands until so many agents are there [0 in real time, else 1]")
                   ->check(CLI::Range(0, 22));
  app.add_option("--sync-timeout", server.agents.syncTimeout,
                 "Drop an agent silent for so many seconds; 0: never [60]")
      ->check(CLI::NonNegativeNumber);
  auto* end = app.add_option("--max-seconds", maxSeconds, "End after so much simulated time")
                  ->check(CLI::PositiveNumber);
  auto* kickOff = app.add_option("--kickoff-after", kickOffAfter, "Kick off by itself after so many seconds")
                      ->check(CLI::NonNegativeNumber);
  app.add_option("--half-time", server.simulation.rules.halfTime, "Length of a half in seconds [300]")
      ->check(CLI::PositiveNumber);
  app.add_option("--engine", server.simulation.world.engine, "Physics engine [ode]");
  app.add_option("--monitor-step", monitorStep, "Seconds between two messages to a monitor [0.04]")
      ->check(CLI::Range(0.02, 10.0));
  app.add_flag("--ground-truth", server.simulation.players.groundTruth,
               "Send every agent the true state as well");
  app.add_option("--ground-truth-decimals", server.simulation.players.groundTruthDecimals,
                 "Digits behind the point of the true state [2]")
      ->check(CLI::Range(0, 9));
  app.add_option("--stats", options.statisticsFile, "Write what the run cost here at the end, as JSON");
  app.add_flag("--die-with-parent", options.dieWithParent, "End when the process that started this one ends");
  app.add_flag("-v,--verbose", options.verbose, "Say more");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::printf("%s", app.help().c_str());
    std::exit(0);
  }

  if (!isLoopback(bind) && token.empty())
    throw std::runtime_error("--bind " + bind + " opens the monitor port to others: set a --token");
  server.agents.address = server.monitors.address = bind;
  server.monitors.token = token;
  server.monitors.interval =
      std::max(1, static_cast<int>(monitorStep / server.simulation.world.stepSeconds + 0.5));
  server.realTime = *realTimeOption ? realTime : !server.agents.sync;
  server.waitForAgents = *wait ? waitForAgents : server.realTime ? 0 : 1;
  if (*end) server.maxSeconds = maxSeconds;
  if (*kickOff) server.simulation.rules.kickOffAfter = kickOffAfter;
  if (seed == 0) seed = std::random_device()();
  server.simulation.seed = seed;
  return options;
}

int run(const Options& options) {
  if (options.dieWithParent) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() == 1) return 0;  // it ended before we asked
  }
  handleSignals();
  Server server(options.server, [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); });
  if (!options.portsFile.empty()) writePorts(options.portsFile, server.agentPort(), server.monitorPort());
  std::printf("simulator: agent port %d, monitor port %d, seed %llu\n", server.agentPort(),
              server.monitorPort(), static_cast<unsigned long long>(options.server.simulation.seed));
  std::fflush(stdout);
  server.run(stopRequested);
  const ServerStatistics& statistics = server.statistics();
  if (!options.statisticsFile.empty()) writeStatistics(options.statisticsFile, statistics);
  if (options.verbose)
    std::printf(
        "simulator: %llu cycles, %.1f us of CPU each, %.1f x real time\n",
        static_cast<unsigned long long>(statistics.cycles),
        1e6 * statistics.cpuSeconds / static_cast<double>(std::max<std::uint64_t>(1, statistics.cycles)),
        statistics.simulatedSeconds / std::max(1e-9, statistics.wallSeconds));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(parseOptions(argc, argv));
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "simulator: %s\n", problem.what());
    return badInput;
  }
}
