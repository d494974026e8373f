// bin/rdb: the debugger of a running agent (thesis A.6.1).
#include <charconv>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "Batch.h"
#include "Console.h"
#include "framework/CommandLine.h"
#include "framework/ConfigFolder.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "inspect/DebugServer.h"

namespace {

using namespace plumbline;
using namespace plumbline::rdb;

constexpr double connectSeconds = 3;

struct Options {
  std::string address = "127.0.0.1", token, aliases, script, history = History::standardPath();
  std::vector<std::string> commands;
  Batch::Options batch;
};

void declare(CommandLine& app, Options& options) {
  app.option("address", options.address, "where the agent's debug port is: HOST or HOST:PORT").showDefault();
  app.option(
         "--exec", options.commands,
         "run this command, print the answer and end; may be repeated; several watches run at the same time")
      .oneValueEach();
  app.option("--script", options.script, "run the commands of FILE and end; `sleep S` waits");
  app.option("--seconds", options.batch.seconds, "with --exec: a watch or plot ends after so long")
      .range(0.01, 1e6);
  app.option("--png", options.batch.png, "with --exec or --script: draw the plot to FILE");
  app.option("--token", options.token, "token of the agent, if it runs on another machine");
  app.option("--alias", options.aliases, "file of aliases, lines A|B [config/alias.cfg]");
  app.option("--history", options.history, "file that keeps what was typed").showDefault();
  app.footer(
      "Commands are the agent's (`help` lists them) and: plot VALUE [WINDOW [COUNT [SECONDS]]],\n"
      "plot off [WINDOW], png WINDOW FILE, run FILE, quit.\n"
      "On a display each plot has a window, too, by gnuplot-qt.\n"
      "Tab completes, Page Up shows what has gone by, Ctrl-C ends.\n"
      "Exit status with --exec and --script: 0, or 2 with the agent's error.\n"
      "Examples:\n"
      "  bin/agent --start-simulator --debug               an agent to look at\n"
      "  bin/rdb                                           its console\n"
      "  bin/rdb --exec \"get r:BallPos.relative.x\"         a value for a shell\n"
      "  bin/rdb --exec \"watch r:BallPos every 1s\" --seconds 10\n"
      "  bin/rdb --exec \"plot r:BallPos.relative.x ball\" --exec \"plot r:BallPos.relative.y ball\" --png "
      "ball.png\n"
      "  bin/rdb 192.168.1.20:3300 --token secret          an agent elsewhere, --debug-address and "
      "--debug-token");
}

int portOf(std::string& address) {
  const auto colon = address.find(':');
  if (colon == std::string::npos) return inspect::DebugServerOptions::standardPort;
  int port = 0;
  const char *begin = address.data() + colon + 1, *end = address.data() + address.size();
  const auto read = std::from_chars(begin, end, port);
  if (read.ec != std::errc{} || read.ptr != end || port < 1 || port > 65535)
    throw std::runtime_error(address + ": a port, 1 to 65535, must follow the colon");
  address.resize(colon);
  if (address.empty()) address = "127.0.0.1";
  return port;
}

Aliases readAliases(const Options& options) {
  if (!options.aliases.empty()) return Aliases::read(options.aliases);
  const std::string path = configFolder() + "/alias.cfg";
  return std::filesystem::exists(path) ? Aliases::read(path) : Aliases();
}

int run(Options& options) {
  const int port = portOf(options.address);
  StopSignal stop;
  stop.catchSignals();
  Link link(options.address, port, options.token, stop.fileDescriptor());
  Session session(link, readAliases(options));
  if (options.commands.empty() && options.script.empty()) {
    History history(options.history);
    Console(link, session, history, stop).run();
    if (const std::string why = history.save(); !why.empty()) throw std::runtime_error(why);
    return 0;
  }
  if (const std::string why = link.connect(connectSeconds); !why.empty()) {
    if (stop.requested()) throw Stopped("stopped before it was connected");
    throw std::runtime_error(why + "; was the agent started with --debug?");
  }
  Batch batch(link, session, stop, options.batch);
  for (const std::string& command : options.commands) batch.run(command, "");
  if (!options.script.empty() && !batch.runFile(options.script)) throw Stopped("stopped within the script");
  if (!options.commands.empty()) batch.follow();
  batch.showPlots();
  return 0;
}

int runProgram(int argc, char** argv) {
  Options options;
  CommandLine app("Shows values of a running agent and changes them.", "rdb");
  declare(app, options);
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  std::setlocale(LC_ALL, "");
  std::setlocale(LC_NUMERIC, "C");
  return run(options);
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("rdb", runProgram, argc, argv); }
