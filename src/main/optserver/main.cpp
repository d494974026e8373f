#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <list>

#include "Measuring.h"
#include "SearchPage.h"
#include "framework/CommandLine.h"
#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "framework/GuardedMain.h"
#include "framework/ProgressReport.h"
#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "optimization/farm/FarmClient.h"
#include "optimization/farm/FarmServer.h"
#include "simspark/ChildProcess.h"
#include "training/Study.h"
#include "training/TaskPage.h"

namespace plumbline {
namespace {

struct Options {
  std::string study, folder;
  training::StudyChanges changes;
  farm::FarmOptions farm;
  int workers = 0;
  double every = 5;
  int measured = 0;
  std::uint64_t firstSeed = 0;
  bool status = false, serves = false, show = false, parameters = false;
  pages::PageServer::Config web{.port = SearchPage::standardPort};
};

/// The search as given on the command line.
std::string commandOf(const Options& options) {
  std::string text = "bin/optserver " + options.study;
  for (const auto& [key, value] : options.changes.options) text += fmt::format(" --option {}={}", key, value);
  if (options.changes.seed) text += fmt::format(" --seed {}", *options.changes.seed);
  return text;
}

/// A folder of its own for each study, and for each change of it.
std::string defaultFolder(const Options& options) {
  std::string name = std::filesystem::path(options.study).stem().string();
  for (const auto& [key, value] : options.changes.options) name += fmt::format("-{}{}", key, value);
  if (options.changes.seed) name += fmt::format("-seed{}", *options.changes.seed);
  std::ranges::replace(name, '/', '_');
  return name + ".search";
}

/// KEY=VALUE.
void takeOption(const std::string& text, training::StudyChanges& changes) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) throw OptionError("\"" + text + "\" is not KEY=VALUE");
  changes.options[text.substr(0, equals)] = text.substr(equals + 1);
}

/// Where this machine reaches what listens at an address.
std::string reachable(const std::string& address) { return address == "0.0.0.0" ? "127.0.0.1" : address; }

/// Workers on this machine; a worker that ends before the search is started again, at most once a second.
class LocalWorkers {
public:
  LocalWorkers(int count, const farm::FarmAddress& server, const std::string& log) : log_(log) {
    command_ = {programFolder() + "/optworker", "--host",   server.host,   "--port",
                std::to_string(server.port),    "--config", configFolder()};
    settings_.outputFile = log;
    // A list of processes shows arguments to everybody.
    if (!server.token.empty()) settings_.environment = {"PLUMBLINE_TOKEN=" + server.token};
    for (int i = 0; i < count; ++i) all_.emplace_back(start());
  }
  /// All get their signal before the first is waited for.
  ~LocalWorkers() {
    for (const auto& worker : all_) worker->askToStop();
  }
  LocalWorkers(const LocalWorkers&) = delete;
  LocalWorkers& operator=(const LocalWorkers&) = delete;
  /// Throws std::runtime_error if none of them can work.
  void keep(double now) {
    if (now - checked_ < 1) return;
    checked_ = now;
    for (auto& worker : all_) {
      if (worker->running()) continue;
      if (worker->exitStatus() == 2) throw std::runtime_error("a worker cannot work; see " + log_);
      worker = start();
    }
  }

private:
  std::unique_ptr<simspark::ChildProcess> start() const {
    return std::make_unique<simspark::ChildProcess>(command_, settings_);
  }
  std::string log_;
  std::vector<std::string> command_;
  simspark::ChildSettings settings_;
  std::list<std::unique_ptr<simspark::ChildProcess>> all_;
  double checked_ = 0;
};

/// The live table.
class Table {
public:
  explicit Table(const training::Study& study, double every) : stop_(study.search.stop), every_(every) {}
  void line(const farm::FarmServer& server, const Search& search, bool last = false) {
    const farm::FarmProgress& progress = server.progress();
    if (!last && progress.seconds < next_) return;
    next_ = progress.seconds + every_;
    if (lines_++ % 20 == 0)
      fmt::print("{:>10} {:>10} {:>10} {:>8} {:>9} {:>8} {:>8} {:>6}  figures\n", "generation", "best",
                 "mean", "sigma", "trials", "runs/s", "workers", "left");
    const Optimizer& optimizer = search.optimizer();
    std::string figures;
    for (const auto& [name, value] : progress.figures) figures += fmt::format(" {} {:.4g}", name, value);
    fmt::print("{:>10} {:>10.4g} {:>10.4g} {:>8.3g} {:>9} {:>8.1f} {:>4}/{:<3} {:>6} {}\n",
               optimizer.generations(), optimizer.bestCost(), progress.lastCost, optimizer.sigma(),
               search.trials(), static_cast<double>(progress.runs) / std::max(1e-9, progress.seconds),
               server.busy(), server.workers(), left(progress, optimizer), figures);
    std::fflush(stdout);
  }

private:
  std::string left(const farm::FarmProgress& progress, const Optimizer& optimizer) {
    if (begin_ < 0) begin_ = static_cast<double>(optimizer.generations());
    const double done = static_cast<double>(optimizer.generations()) - begin_;
    if (stop_.maxGenerations > 1'000'000'000 || done < 1) return "?";
    return durationText(progress.seconds / done *
                        static_cast<double>(stop_.maxGenerations - optimizer.generations()));
  }
  StopCriteria stop_;
  double every_, next_ = 0, begin_ = -1;
  int lines_ = 0;
};

/// What has been found: the parameters, and the file that the agent reads if the task has one.
void writeResult(const Options& options, const training::Study& study, const Search& search) {
  const Optimizer& optimizer = search.optimizer();
  const Eigen::VectorXd found = optimizer.favourite();
  std::string text = fmt::format(
      "# Found by {}: {} generations, {} runs. The middle of the last\n"
      "# generation; the best single cost was {:.6g}.\n",
      commandOf(options), optimizer.generations(), search.runs(), optimizer.bestCost());
  for (std::size_t i = 0; i < study.parameters.size(); ++i)
    text += fmt::format("{}: {}\n", study.parameters[i].name, found[static_cast<Eigen::Index>(i)]);
  writeFile(options.folder + "/found.yaml", text);
  const std::string heading =
      fmt::format("Found by {}: seed {}, {} generations, {} runs.", commandOf(options), study.search.seed,
                  optimizer.generations(), search.runs());
  const std::string file = training::makeTask(study.task, study.options)->file(found, heading);
  if (!file.empty()) writeFile(options.folder + "/" + study.task + ".yaml", file);
}

/// Measures before and after, over the same seeds; the task's file then has the figures. Only before, if
/// nothing was found yet.
int measureBoth(const Options& options) {
  const training::Study study = training::readStudy(options.study, options.changes);
  const std::string path = options.folder + "/found.yaml";
  const bool searched = std::filesystem::exists(path);
  Eigen::VectorXd found(static_cast<Eigen::Index>(study.parameters.size()));
  if (searched) {
    const ConfigFile file(path);
    for (std::size_t i = 0; i < study.parameters.size(); ++i)
      found[static_cast<Eigen::Index>(i)] = file.root().get<double>(study.parameters[i].name);
    file.checkUnknown();
  }
  StopSignal stop;
  stop.catchSignals();
  ProgressReport report("optserver");
  report.update("measuring");
  measure(study, "start", study.space().start, options.measured, options.firstSeed);
  if (!searched) {
    fmt::print(stderr, "optserver: no {} was found: these are the figures of the start only\n", path);
    return 0;
  }
  const std::map<std::string, double> figures =
      measure(study, "found", found, options.measured, options.firstSeed);
  std::string heading =
      fmt::format("Found by {}: seed {}.\nMeans of {} tries with fresh seeds from {} on:", commandOf(options),
                  study.search.seed, options.measured, options.firstSeed);
  for (const auto& [name, value] : figures)
    if (!name.ends_with(training::deviationSuffix)) heading += fmt::format(" {} {:.4g}", name, value);
  const std::string text = training::makeTask(study.task, study.options)->file(found, heading, figures);
  const std::string file = options.folder + "/" + study.task + ".yaml";
  if (text.empty()) return 0;
  writeFile(file, text);
  fmt::print("optserver: {} has these figures\n", file);
  return 0;
}

/// Waits for Ctrl-C, which ends a run that is only viewed.
int waitForEnd(const StopSignal& stop) {
  std::fflush(stdout);
  pollfd ended{stop.fileDescriptor(), POLLIN, 0};
  while (poll(&ended, 1, -1) < 0 && errno == EINTR) {
  }
  return 0;
}

int serve(Options& options) {
  const training::Study study = training::readStudy(options.study, options.changes);
  if (options.show && !std::filesystem::exists(options.folder + "/evaluations.jsonl"))
    throw std::runtime_error(options.folder + ": has no evaluations.jsonl, so there is nothing to show");
  std::filesystem::create_directories(options.folder);
  Search search = study.makeSearch();
  farm::RunHistory history(search);
  farm::Journal journal(
      options.folder + "/evaluations.jsonl", study.mark(), [&](const farm::JournalEntry& entry) {
        history.addResult(entry.costs);
        const ResultStatus status =
            entry.givenUp ? search.giveUp(entry.number) : search.tell(entry.number, entry.costs);
        if (status == ResultStatus::unknown)
          throw std::invalid_argument("a result of a trial that does not exist yet");
      });
  if (journal.resumed() > 0)
    fmt::print("optserver: continues from {} results in {}\n", journal.resumed(), journal.path());
  StopSignal stop;
  stop.catchSignals();
  history.look();
  std::unique_ptr<SearchPage> page;
  if (options.serves) {
    page = std::make_unique<SearchPage>(options.web, study, options.study, options.folder);
    fmt::print("optserver: page {}\n", page->address());
    std::fflush(stdout);
    page->show(search, history, nullptr, options.show);
  }
  if (options.show) return waitForEnd(stop);
  farm::FarmServer server(
      search, &journal,
      {study.task, study.options.values(), static_cast<std::int64_t>(study.parameters.size())}, options.farm);
  fmt::print("optserver: port {}, {} parameters, results in {}\n", server.port(), study.parameters.size(),
             options.folder);
  std::fflush(stdout);
  writeFile(options.folder + "/port", std::to_string(server.port()) + "\n");
  LocalWorkers workers(options.workers, {reachable(options.farm.address), server.port(), options.farm.token},
                       options.folder + "/workers.log");
  Table table(study, options.every);
  server.onResult([&](std::span<const double> costs) { history.addResult(costs); });
  std::int64_t written = search.optimizer().generations();
  const bool over = search.isDone() || server.serve(stop.fileDescriptor(), [&] {
    if (!search.isDone()) workers.keep(server.progress().seconds);
    table.line(server, search);
    history.look();
    if (page) page->show(search, history, &server, false);
    if (search.optimizer().generations() >= written + 10) {
      written = search.optimizer().generations();
      writeResult(options, study, search);
    }
  });
  table.line(server, search, true);
  history.look();
  if (page) page->show(search, history, &server, over);
  writeResult(options, study, search);
  if (!over) {
    fmt::print(stderr, "optserver: stopped; the same command continues from {}\n", journal.path());
    return 130;
  }
  fmt::print("optserver: over ({}); found: {}/found.yaml\n", name(search.optimizer().stopReason()),
             options.folder);
  std::fflush(stdout);
  if (page) fmt::print("optserver: the page stays until Ctrl-C; --show opens it again\n");
  return page ? waitForEnd(stop) : 0;
}

int runProgram(int argc, char** argv) {
  Options options;
  options.farm.port = farm::FarmAddress::standardPort;
  CommandLine app("Farms an optimisation out: workers (bin/optworker) take parameters and bring costs.",
                  "optserver");
  app.option("STUDY", options.study, "What is searched and how, as config/optimisation/standUpFront.yaml");
  app.actionOnAll(
         "--option",
         [&options](const std::vector<std::string>& all) {
           for (const std::string& one : all) takeOption(one, options.changes);
         },
         "KEY=VALUE of the task, instead of the study's: --option type=3; may be repeated")

      .oneValueEach();
  app.option("--seed", options.changes.seed, "Of the search, in place of the study's")
      .range(0, 1'000'000'000);
  app.option("--folder", options.folder, "Folder for results [NAME.search]; an existing search is continued");
  app.option("--workers", options.workers, "Workers to start on this machine").range(0, 256).showDefault();
  app.option("--port", options.farm.port, "Port for workers; 0: a free one").portOrFree().showDefault();
  app.option("--bind", options.farm.address, "Its address; any but loopback needs --token").showDefault();
  app.option("--token", options.farm.token, "What workers have to say").orVariable("PLUMBLINE_TOKEN");
  app.option("--patience", options.farm.dispatch.patience,
             "If a worker takes longer for a trial, another worker gets the trial [s]")
      .range(0.1, 1e6)
      .showDefault();
  app.option("--every", options.every, "Seconds between lines of the table").range(0.1, 1e6).showDefault();
  app.option("--measure", options.measured,
             "Instead of searching: number of runs, with seeds that no search uses, of the start and of "
             "the result")
      .range(1, 1'000'000);
  app.option("--first-seed", options.firstSeed,
             "With --measure: the first of those seeds; what was chosen by some is judged by others")
      .range(0, 1'000'000'000)
      .needs("--measure")
      .showDefault();
  const CommandOption web =
      app.option("--web", options.web.port, "Serve a page of the run; 0: a free port, which is printed")
          .valueOptional()
          .showDefault(std::to_string(SearchPage::standardPort))
          .portOrFree();
  web.notes(options.serves);
  app.option("--web-address", options.web.address, "With --web: where others may reach it; needs --web-token")
      .needs(web)
      .showDefault();
  app.option("--web-token", options.web.token, "With --web: the page opens with ?token=TOKEN only")
      .needs(web);
  app.flag("--show", options.show, "With --web: shows existing results, and does not search").needs(web);
  app.flag("--status", options.status, "Asks the server at --bind and --port for its progress");
  app.flag("--parameters", options.parameters, "Prints a page of all tasks with their options and ends");
  app.action("--config", useConfigFolder,
             "folder of the configuration [config/ here, else the one next to bin/]");
  std::string tasks;
  for (const training::TaskKind& kind : training::searchTasks())
    tasks += fmt::format("  {:<10} {}\n", kind.name, kind.what);
  app.footer("Tasks (--parameters prints their options):\n" + tasks +
             "Stopped or killed, it goes on where it was with the same command.\n"
             "Examples:\n  bin/optserver config/optimisation/standUpFront.yaml --workers 2\n"
             "  bin/optserver config/optimisation/standUpFront.yaml --option type=3 --workers 2\n"
             "  bin/optserver config/optimisation/standUpFront.yaml --measure 1000\n"
             "  bin/optserver config/optimisation/standUpFront.yaml --web --show\n"
             "  bin/optserver --status\n"
             "  bin/optserver study.yaml --bind 0.0.0.0 --token SECRET");
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  if (options.parameters) {
    fmt::print("{}", training::taskPage());
    return 0;
  }
  if (options.status) {
    fmt::print("{}\n", farm::readStatus({options.farm.address, options.farm.port, options.farm.token}));
    return 0;
  }
  if (options.study.empty()) {
    fmt::print(stderr, "optserver: {}\n", commandLineError(app, "STUDY is missing"));
    return 2;
  }
  if (options.folder.empty()) options.folder = defaultFolder(options);
  return options.measured > 0 ? measureBoth(options) : serve(options);
}

}  // namespace
}  // namespace plumbline

int main(int argc, char** argv) {
  return plumbline::guardedMain("optserver", plumbline::runProgram, argc, argv);
}
