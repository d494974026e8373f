// bin/logtool: what is in logs of agents, parts of them, what two differ in, and their values as tables.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "GapRun.h"
#include "Listing.h"
#include "framework/CommandLine.h"
#include "framework/GuardedMain.h"
#include "framework/ProgressReport.h"
#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "gap/run/RunFile.h"
#include "record/LogCompare.h"
#include "record/LogCopy.h"
#include "record/LogTable.h"

namespace {

using namespace plumbline;
using namespace plumbline::record;

constexpr int differ = 1, badInput = 2;

struct Options {
  std::string log, other, target, thread, csv, gap, motion = "from a log of the agent", cycles;
  std::vector<std::string> logs;
  LogPart part;
  double tolerance = 0;
};

void addPart(CommandLine& command, Options& options) {
  command.option("--from", options.part.from, "from this time of the log on [s]").notNegative();
  command.option("--to", options.part.to, "up to this time [s]").notNegative();
  command.option("--cycles", options.cycles, "only cycles FIRST:LAST, by their numbers");
}

void addOnly(CommandLine& command, Options& options, const std::string& what) {
  command.option("--only", options.part.only, what).byCommas();
}

void readCycles(Options& options) {
  if (options.cycles.empty()) return;
  std::istringstream text(options.cycles);
  char colon = 0;
  if (!(text >> options.part.firstCycle >> colon >> options.part.lastCycle) || colon != ':' ||
      text.peek() != std::char_traits<char>::eof() || options.cycles.find('-') != std::string::npos ||
      options.part.firstCycle > options.part.lastCycle)
    throw std::runtime_error("--cycles is FIRST:LAST, as 100:200, not " + options.cycles);
}

int list(const Options& options) {
  LogReader log(options.log);
  fmt::print("{}", logtool::listing(log));
  return 0;
}

int compare(const Options& options, const Progress& progress) {
  const LogComparison result =
      compareLogs(options.log, options.other, options.part.only, options.tolerance, progress);
  for (const std::string& line : result.missing) fmt::print("{}\n", line);
  if (!result.differences.empty()) {
    fmt::print("{:>8} {:>9}  {:40} {:>24} {:>24}  {}\n", "cycle", "time [s]", "first difference", options.log,
               options.other, "cycles");
    for (const LogDifference& d : result.differences)
      fmt::print("{:>8} {:>9.2f}  {:40} {:>24} {:>24}  {}\n", d.cycle, d.time, d.representation + d.field,
                 d.left.substr(0, 24), d.right.substr(0, 24), d.cycles);
  }
  if (result.onlyLeft > 0) fmt::print("{} cycles are only in {}\n", result.onlyLeft, options.log);
  if (result.onlyRight > 0) fmt::print("{} cycles are only in {}\n", result.onlyRight, options.other);
  if (result.same()) fmt::print("the same in {} cycles\n", result.compared);
  return result.same() ? 0 : differ;
}

int exportLog(const Options& options, const Progress& progress) {
  if (options.csv.empty() == options.gap.empty())
    throw std::runtime_error("give one of --csv FILE and --gap FOLDER");
  LogReader log(options.log);
  const LogReader::Thread& thread = log.thread(options.thread);
  if (!options.gap.empty()) {
    const gap::Run run = logtool::gapRun(log, thread, options.part, options.motion, progress);
    gap::writeRun(run, options.gap);
    fmt::print("{}: {} cycles of {}\n", options.gap, run.size(), run.robot);
    return 0;
  }
  const auto columns = logColumns(log, thread, options.part.only);
  if (options.csv == "-") {
    writeCsv(log, thread, columns, options.part, std::cout, progress);
    return std::cout.flush() ? 0 : badInput;
  }
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // else a lack of memory looks like the end of the text
  const std::uint64_t lines = writeCsv(log, thread, columns, options.part, text, progress);
  writeFile(options.csv, text.str());
  fmt::print("{}: {} lines of {} columns\n", options.csv, lines, columns.size() + 2);
  return 0;
}

int cut(const Options& options, const Progress& progress) {
  const std::uint64_t cycles = cutLog(options.log, options.target, options.part, progress);
  fmt::print("{}: {} cycles\n", options.target, cycles);
  return 0;
}

int join(const Options& options, const Progress& progress) {
  const std::uint64_t cycles = joinLogs(options.logs, options.target, progress);
  fmt::print("{}: {} cycles of {} logs\n", options.target, cycles, options.logs.size());
  return 0;
}

using Command = std::function<int(const Options&, const Progress&)>;

/// The subcommands; `chosen` becomes the one of the command line.
void declare(CommandLine& app, Options& options, Command& chosen) {
  app.requireCommand();
  CommandLine lists = app.command("list", "Threads, cycles and representations of a log");
  lists.option("log", options.log, "folder or .db3 file").required();
  lists.whenChosen([&] { chosen = [](const Options& o, const Progress&) { return list(o); }; });

  CommandLine cuts = app.command("cut", "A part of a log as a new one");
  cuts.option("log", options.log, "folder or .db3 file").required();
  cuts.option("target", options.target, "new folder").required();
  addPart(cuts, options);
  addOnly(cuts, options, "these representations, by commas");
  cuts.whenChosen([&] { chosen = cut; });

  CommandLine joins = app.command("join", "Logs one behind the other as a new one");
  joins.option("target", options.target, "new folder").required();
  joins.option("logs", options.logs, "folders or .db3 files").required();
  joins.whenChosen([&] { chosen = join; });

  CommandLine compares =
      app.command("compare", "Where two logs differ first, by representation, field and cycle");
  compares.option("left", options.log, "a log").required();
  compares.option("right", options.other, "another one").required();
  addOnly(compares, options, "these representations, by commas");
  compares.option("--tolerance", options.tolerance, "numbers may differ by so much").notNegative();
  compares.whenChosen([&] { chosen = compare; });

  CommandLine exports = app.command("export", "Values as a table, or as a run of bin/gap");
  exports.option("log", options.log, "a log").required();
  exports.option("--csv", options.csv, "write a table to FILE; -: to standard output");
  exports.option("--gap", options.gap, "write a run (run.json, run.csv.gz) into this new folder");
  exports.option("--motion", options.motion, "with --gap: what was played");
  exports.option("--thread", options.thread, "where the log has several");
  addPart(exports, options);
  addOnly(exports, options, "with --csv: representations or parts of them, as BallPos.relative,RobotPose");
  exports.whenChosen([&] { chosen = exportLog; });

  app.footer(
      "Exit status: 0; 1 if compare finds a difference; 2 for bad input; 130 after Ctrl-C.\n"
      "Examples:\n"
      "  bin/agent --start-simulator --log game           record\n"
      "  bin/logtool list game\n"
      "  bin/logtool cut game kick --from 4 --to 6\n"
      "  bin/logtool compare game again\n"
      "  bin/logtool export game --csv ball.csv --only BallPos,RobotPose.position\n"
      "  bin/logtool export game --gap run --from 2 && bin/gap diagnose run");
}

int runProgram(int argc, char** argv) {
  Options options;
  Command chosen;
  CommandLine app(
      "Logs that agents have recorded (bin/agent --log): folders that ROS 2's tools read as well.",
      "logtool");
  declare(app, options, chosen);
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  readCycles(options);
  StopSignal stop;
  stop.catchSignals();
  ProgressReport report("logtool");
  return chosen(options, [&](double share) {
    report.update(options.log.empty() ? options.target : options.log, share);
  });
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("logtool", runProgram, argc, argv); }
