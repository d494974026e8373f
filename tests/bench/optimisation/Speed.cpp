#include "Speed.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>
#include <vector>

#include "Peer.h"
#include "optimization/Optimizers.h"
#include "optimization/Search.h"
#include "optimization/farm/FarmClient.h"
#include "optimization/farm/FarmServer.h"
#include "optimization/farm/Journal.h"
#include "optimization/farm/RunHistory.h"
#include "training/MotionTrial.h"
#include "training/SearchTask.h"

namespace plumbline::bench {
namespace {

Search searchOf(const training::SearchTask& task, int generations) {
  OptimizerOptions options;
  options.population = 16;
  options.stop.maxGenerations = generations;
  return {makeOptimizer("cmaes", SearchSpace::of(task.parameters()), options), Averaging{2, 4}, 1};
}

/// Seconds of the processor for the whole search.
double work(farm::ParameterSource& source, training::SearchTask& task) {
  const double begin = processorSeconds();
  while (!source.isOver()) {
    const auto trial = source.next(0.2);
    if (!trial) continue;
    std::vector<double> costs;
    std::map<std::string, double> figures;
    for (const std::uint64_t seed : trial->seeds) {
      const auto outcome = task.run(trial->parameters, seed);
      costs.push_back(outcome.cost);
      for (const auto& [key, value] : outcome.figures)
        figures[key] += value / static_cast<double>(trial->seeds.size());
    }
    source.tell(*trial, costs, figures);
  }
  return processorSeconds() - begin;
}

/// Seconds of a run in this process.
double bareRun(const std::string& name, const std::map<std::string, std::string>& options, int generations) {
  const auto task = training::makeTask(name, TaskOptions(options));
  Search search = searchOf(*task, generations);
  farm::LocalSource source(search);
  const double seconds = work(source, *task);
  return seconds / static_cast<double>(search.runs());
}

/// Seconds of a run of server and worker; the file of results is new.
double farmedRun(const std::string& name, const std::map<std::string, std::string>& options, int generations,
                 const std::string& file) {
  const auto task = training::makeTask(name, TaskOptions(options));
  Search search = searchOf(*task, generations);
  farm::RunHistory history(search);
  std::filesystem::remove(file);
  farm::Journal journal(file, name, [](const farm::JournalEntry&) {});
  farm::FarmServer server(search, &journal,
                          {name, options, static_cast<std::int64_t>(task->parameters().size())}, {});
  server.onResult([&](std::span<const double> costs) { history.addResult(costs); });
  const int stop = eventfd(0, EFD_CLOEXEC);
  std::thread serving([&] { server.serve(stop, [&] { history.look(); }); });
  farm::FarmClient client({"127.0.0.1", server.port(), ""}, "bench");
  const double seconds = work(client, *task);  // of both threads: it is the process's time
  serving.join();
  close(stop);
  return seconds / static_cast<double>(search.runs());
}

Spread spreadOf(std::vector<double> values) {
  std::ranges::sort(values);
  return {values[values.size() / 2], values.front(), values.back()};
}

}  // namespace

TaskSpeed speedOf(const std::string& name, const std::map<std::string, std::string>& options, int generations,
                  int passes) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("plumbline-bench-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::vector<double> farmed, overhead;
  // In turn, as a busy machine's caches make all runs slower for a while.
  for (int pass = 0; pass < passes; ++pass) {
    const double bare = bareRun(name, options, generations);
    farmed.push_back(farmedRun(name, options, generations, folder / "evaluations.jsonl"));
    overhead.push_back(farmed.back() / bare - 1);
  }
  std::filesystem::remove_all(folder);
  return {spreadOf(farmed).median, spreadOf(overhead)};
}

CycleTimes cycleTimes(int type, int cycles) {
  training::MotionTrial trial(type);
  trial.beginWalk();
  CycleTimes times;
  for (int i = 0; i < cycles; ++i) {
    const double begin = processorSeconds();
    const auto output = trial.walkOutput(Vec2(0.3, 0), 0.2);
    const double planned = processorSeconds();
    const JointArray speeds = trial.control.update(trial.robot.sense().angle, output.angles, trial.dt);
    const double controlled = processorSeconds();
    trial.robot.act(speeds);
    times.walk += (planned - begin) / cycles;
    times.control += (controlled - planned) / cycles;
    times.physics += (processorSeconds() - controlled) / cycles;
  }
  return times;
}

}  // namespace plumbline::bench
