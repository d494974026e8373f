// bin/simulator: the embedded simulator as a server that speaks SimSpark's protocol.
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "Options.h"
#include "framework/CommandLine.h"
#include "framework/GuardedMain.h"
#include "simulation/replay/ReplayReport.h"
#include "simulation/server/Reports.h"
#include "simulation/server/Server.h"
#include "web/WebMonitor.h"

using namespace plumbline;
using namespace plumbline::simulation;

namespace {

constexpr int badInput = 2;
std::atomic<bool> stopRequested = false, recordingLost = false;

void requestStop(int) { stopRequested = true; }

void handleSignals() {
  struct sigaction action {};
  action.sa_handler = requestStop;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
}

/// The page is one more monitor of this simulator, in threads of its own.
std::unique_ptr<web::WebMonitor> openPage(const Options& options, const Server& server) {
  web::WebMonitorConfig config;
  config.server.port = *options.webPort;
  config.server.anyPort = options.anyWebPort;
  const std::string& address = options.server.monitors.address;
  config.live.host = address == "0.0.0.0" || address == "::" ? "127.0.0.1" : address;
  config.live.port = server.monitorPort();
  config.live.token = options.server.monitors.token;
  config.live.drawingPortOptional = !options.drawingPort;
  if (options.drawingPort) config.live.drawingPort = *options.drawingPort;
  config.live.record = options.recordFile;
  config.live.recordingLost = [](const std::string& why) {
    std::fprintf(stderr, "simulator: the recording ends here: %s\n", why.c_str());
    recordingLost = true;
  };
  auto page = std::make_unique<web::WebMonitor>(config);
  std::printf("simulator: watch at %s\n", page->address().c_str());
  if (options.drawingPort) std::printf("simulator: drawings on UDP port %d\n", page->drawingPort());
  if (!page->drawingProblem().empty())
    std::printf("simulator: without the agents' drawings: %s\n", page->drawingProblem().c_str());
  std::fflush(stdout);
  return page;
}

void serve(const Options& options) {
  Server server(options.server,
                [](const std::string& line) { std::fprintf(stderr, "simulator: %s\n", line.c_str()); });
  std::unique_ptr<web::WebMonitor> page;
  if (options.webPort) page = openPage(options, server);
  if (!options.portsFile.empty())
    writePorts(options.portsFile, server.agentPort(), server.monitorPort(), page ? page->port() : 0,
               server.fieldPort());
  std::printf("simulator: agent port %d, monitor port %d, seed %llu\n", server.agentPort(),
              server.monitorPort(), static_cast<unsigned long long>(options.server.simulation.seed));
  std::fflush(stdout);
  server.run(stopRequested);
  page.reset();  // its recording ends here
  const ServerStatistics& run = server.statistics();
  if (!options.statisticsFile.empty()) writeStatistics(options.statisticsFile, run);
  if (options.verbose)
    std::printf("simulator: %llu cycles, %.1f us of CPU each, %.1f x real time\n",
                static_cast<unsigned long long>(run.cycles),
                1e6 * run.cpuSeconds / static_cast<double>(std::max<std::uint64_t>(1, run.cycles)),
                run.simulatedSeconds / std::max(1e-9, run.wallSeconds));
}

int runProgram(int argc, char** argv) {
  const pid_t parent = getppid();
  const Options options = parseOptions(argc, argv);
  if (options.exitStatus) return *options.exitStatus;
  if (options.dieWithParent) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) return 0;  // it ended before we asked
  }
  if (options.replayFile.empty()) {
    handleSignals();
    serve(options);
  } else  // which a signal ends at once
    std::fputs(replayReport(options.replayFile, options.replayType, options.server.simulation.world).c_str(),
               stdout);
  return recordingLost ? badInput : 0;
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("simulator", runProgram, argc, argv); }
