#include "Speed.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <thread>
#include <vector>

#include "Peer.h"
#include "optimization/Optimizers.h"
#include "optimization/Search.h"
#include "optimization/farm/FarmClient.h"
#include "optimization/farm/FarmServer.h"
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
    for (const std::uint64_t seed : trial->seeds) costs.push_back(task.run(trial->parameters, seed).cost);
    source.tell(*trial, costs, {});
  }
  return processorSeconds() - begin;
}

}  // namespace

TaskSpeed speedOf(const std::string& name, const std::map<std::string, std::string>& options,
                  int generations) {
  TaskSpeed speed;
  {
    const auto task = training::makeTask(name, TaskOptions(options));
    Search search = searchOf(*task, generations);
    farm::LocalSource source(search);
    const double seconds = work(source, *task);
    speed.bare = seconds / static_cast<double>(search.runs());
  }
  const auto task = training::makeTask(name, TaskOptions(options));
  Search search = searchOf(*task, generations);
  farm::FarmServer server(search, nullptr,
                          {name, options, static_cast<std::int64_t>(task->parameters().size())}, {});
  const int stop = eventfd(0, EFD_CLOEXEC);
  std::thread serving([&] { server.serve(stop); });
  farm::FarmClient client({"127.0.0.1", server.port(), ""}, "bench");
  const double seconds = work(client, *task);  // of both threads: it is the process's time
  serving.join();
  close(stop);
  speed.farmed = seconds / static_cast<double>(search.runs());
  return speed;
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
