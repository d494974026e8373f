// bin/webmonitor: a page that shows the game on a monitor port, or a recorded one, in three dimensions.
#include <poll.h>

#include <atomic>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include "framework/CommandLine.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "web/DecisionFiles.h"
#include "web/GameSummary.h"
#include "web/WebMonitor.h"

namespace {

int runProgram(int argc, char** argv) {
  using namespace plumbline;
  constexpr int badInput = 2;
  web::WebMonitorConfig config;
  CommandLine app("Shows a game of SimSpark in the browser; attaches to any monitor port.", "webmonitor");
  app.option("--host", config.live.host, "Where the simulator runs").showDefault();
  app.option("--port", config.live.port, "Its monitor port").port().showDefault();
  app.option("--monitor-token", config.live.token, "Token of its monitor port, if it needs one");
  app.option("--web-port", config.server.port, "Port of the page; 0: a free one").portOrFree().showDefault();
  app.option("--bind", config.server.address, "Address of the page; any but loopback needs --token")
      .showDefault();
  app.option("--token", config.server.token, "The page opens with ?token=TOKEN only");
  const CommandOption drawingPort = app.option("--drawing-port", config.live.drawingPort,
                                               "UDP port of the agents' drawings; 0: a free one, -1: none")
                                        .range(-1, 65535)
                                        .showDefault();
  const CommandOption record = app.option("--record", config.live.record, "Write the match to this file");
  app.option("--replay", config.replay, "Show this match file instead of a running game").excludes(record);
  app.option("--page", config.server.folder, "Folder of the page [where `make web` puts it]");
  std::string summary, output, decisions, replayAddress = "http://localhost:8080/";
  const CommandOption sums =
      app.option("--summary", summary,
                 "Instead of showing a game: write a page about this match file, complete in "
                 "itself: score, ways, shots, passes, falls, decisions")
          .excludes(record);
  app.option("-o,--output", output, "With --summary: the page's file [the match file's name with .html]")
      .needs(sums);
  app.option("--decisions", decisions,
             "With --summary: folder of the files that bin/agent --decisions wrote in that match")
      .needs(sums);
  app.option("--replay-at", replayAddress,
             "With --summary: where bin/webmonitor --replay shows the match, for the page's links")
      .needs(sums)
      .showDefault();
  app.footer(
      "Examples:\n  bin/webmonitor --port 3200\n  bin/webmonitor --replay match.plm\n"
      "  bin/webmonitor --summary match.plm -o match.html\n"
      "  bin/webmonitor --summary match.plm --decisions decisions");
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  config.live.drawingPortOptional = !drawingPort.given();
  StopSignal stop;
  stop.catchSignals();
  if (sums.given()) {
    if (output.empty()) output = std::filesystem::path(summary).replace_extension(".html").string();
    const std::string page = web::builtSummaryPage();
    const std::string decided = decisions.empty() ? "null" : web::gameDecisions(decisions);
    writeFile(output, web::summaryPage(page, web::gameTracks(summary), replayAddress, decided));
    std::printf("webmonitor: %s\n", output.c_str());
    return 0;
  }
  std::atomic<bool> recordingLost = false;
  config.live.recordingLost = [&](const std::string& why) {
    std::fprintf(stderr, "webmonitor: the recording ends here: %s\n", why.c_str());
    recordingLost = true;
  };
  std::optional<web::WebMonitor> running(std::in_place, config);
  const web::WebMonitor& monitor = *running;
  std::printf("webmonitor: %s\n", monitor.address().c_str());
  if (monitor.drawingPort() > 0)
    std::printf("webmonitor: drawings on UDP port %d\n", monitor.drawingPort());
  else if (!monitor.drawingProblem().empty())
    std::printf("webmonitor: without the agents' drawings: %s\n", monitor.drawingProblem().c_str());
  std::fflush(stdout);
  pollfd stopped{stop.fileDescriptor(), POLLIN, 0};
  while (!stop.requested()) poll(&stopped, 1, -1);
  running.reset();
  return recordingLost ? badInput : 0;
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("webmonitor", runProgram, argc, argv); }
