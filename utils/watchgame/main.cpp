// bin/watchgame: sees a game through on any server and writes a line about it; scripts/autoplay/ is made of
// it.
#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <optional>

#include "framework/CommandLine.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "watch/FieldPicture.h"
#include "watch/GameTrack.h"
#include "watch/GameWatch.h"

namespace {

using namespace plumbline;

/// ISO 8601, with the difference to UTC.
std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm local{};
  localtime_r(&time, &local);
  char text[40];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S%z", &local);
  return text;
}

int runProgram(int argc, char** argv) {
  watch::GameWatchOptions options;
  watch::GameLogEntry entry;
  std::string log, trackFile;
  bool quiet = false, events = false, noKickOff = false;
  CommandLine app(
      "Sees a game through by the monitor port: kicks off both halves, counts goals, falls and kicks.",
      "watchgame");
  app.option("--host", options.host, "Where the server runs").showDefault();
  app.option("--port", options.port, "Its monitor port").port().showDefault();
  app.option("--players", options.players, "Number of players for which kick-off waits")
      .range(0, 22)
      .showDefault();
  app.option("--patience", options.patience,
             "Time for which it waits; then it kicks off with the present players [s]")
      .range(0.0, 1e6)
      .showDefault();
  app.option("--settle", options.settle, "Pause before a kick-off [s of real time]")
      .range(0.0, 1e4)
      .showDefault();
  app.option("--hang", options.hang, "Give up when nothing has changed for so long [s of real time]")
      .range(0.1, 1e6)
      .showDefault();
  app.option("--limit", options.limit, "Give up after so long in all [s of real time]").range(0.1, 1e9);
  app.flag("--no-kickoff", noKickOff, "The server kicks off by itself");
  app.flag("--end-server", options.endServer, "Tell the server to end after the game");
  app.option("--end-time", options.endTime,
             "The game is over at this time of its clock [when the server says so]")
      .range(0.1, 1e6);
  app.option("--log", log, "Append a line about the game to this file");
  app.option("--track", trackFile, "Write where everybody is, twice a second of the game, to this file");
  app.option("--server", entry.server, "Name of the server, for the log");
  app.option("--seed", entry.seed, "Its seed, for the log");
  app.option("--half-time", entry.halfTime, "Length of a half, for the log [s]").showDefault();
  app.option("--left", entry.nameLeft, "Name of the left team, for the log [the one it has given]");
  app.option("--right", entry.nameRight, "Name of the right team, for the log");
  const CommandOption quietly = app.flag("--quiet", quiet, "No line per second");
  app.flag("--events", events,
           "Instead of a line per second one where score or play mode has changed, and the score at the end")
      .excludes(quietly);
  app.footer(
      "Exit status: 0 the game is over, 1 it came to no end (the log says why), 2 bad options, 130 after "
      "Ctrl-C.\n"
      "Example:\n  bin/watchgame --port 3200 --players 22 --log games.log");
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  options.kickOff = !noKickOff;
  StopSignal stop;
  stop.catchSignals();
  entry.date = now();
  std::optional<watch::GameTrack> track;
  if (!trackFile.empty()) track.emplace(trackFile);
  std::string shown;  // score, play mode and half of the last line
  const auto print = [&](const simspark::SceneState& scene) {
    const std::string state = fmt::format("{} {} : {} {} {} half {}", scene.teamLeft, scene.scoreLeft,
                                          scene.scoreRight, scene.teamRight, scene.playMode, scene.half);
    if (events && state == shown) return;
    shown = state;
    fmt::print("{} {} robots {}\n", watch::clockText(scene.time), state, scene.robots.size());
    std::fflush(stdout);
  };
  options.everyScene = [&](const simspark::SceneState& scene) {
    if (track) track->observe(scene);
    if (events) print(scene);
  };
  const auto result = watch::watchGame(options, stop, [&](const simspark::SceneState& scene) {
    if (!quiet && !events) print(scene);
  });
  const std::string line = watch::gameLogLine(entry, result);
  if (!log.empty() && result.end != watch::GameEnd::interrupted) watch::appendGameLog(log, line);
  if (!events)
    fmt::print("{}\n", line);
  else if (result.end != watch::GameEnd::interrupted && !shown.empty())
    fmt::print("at the end: {} {} : {} {}\n", result.teamLeft, result.scoreLeft, result.scoreRight,
               result.teamRight);
  if (result.end == watch::GameEnd::over) return 0;
  fmt::print(stderr, "watchgame: {}\n", result.problem);
  return result.end == watch::GameEnd::interrupted ? 130 : 1;
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("watchgame", runProgram, argc, argv); }
