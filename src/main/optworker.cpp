#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <new>

#include "framework/CommandLine.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "optimization/farm/FarmClient.h"
#include "training/SearchTask.h"

namespace plumbline {
namespace {

using farm::FarmClient;

void work(FarmClient& client, const StopSignal& stop) {
  const std::unique_ptr<training::SearchTask> task =
      training::makeTask(client.welcome().task, TaskOptions(client.welcome().options));
  if (static_cast<std::int64_t>(task->parameters().size()) != client.welcome().parameters)
    throw ConfigurationError("the server's task " + client.welcome().task + " has " +
                             std::to_string(client.welcome().parameters) + " parameters, this program's " +
                             std::to_string(task->parameters().size()) + ": they are not of the same build");
  while (!client.isOver() && !stop.requested()) {
    const std::optional<Trial> trial = client.next(0.2);
    if (!trial) continue;
    std::vector<double> costs;
    std::map<std::string, double> figures;
    for (const std::uint64_t seed : trial->seeds) {
      if (stop.requested()) return;
      const TaskOutcome outcome = task->run(trial->parameters, seed);
      costs.push_back(outcome.cost);
      for (const auto& [name, value] : outcome.figures)
        figures[name] += value / static_cast<double>(trial->seeds.size());
    }
    client.tell(*trial, costs, figures);
  }
}

int runProgram(int argc, char** argv) {
  farm::FarmAddress server;
  std::string name;
  double patience = 30;
  CommandLine app(
      "Evaluates the candidates of an optimisation server, in its own simulator, until the search is over.",
      "optworker");
  app.option("--host", server.host, "Where bin/optserver runs").showDefault();
  app.option("--port", server.port, "Its port").port().showDefault();
  app.option("--token", server.token, "The server's token, if it needs one").orVariable("PLUMBLINE_TOKEN");
  app.option("--name", name, "How the server calls it [host and process]");
  app.option("--patience", patience, "Waits so long for a server that is not there, or went away [s]")
      .range(0.0, 1e6)
      .showDefault();
  app.action("--config", useConfigFolder,
             "folder of the configuration [config/ here, else the one next to bin/]");
  app.footer(
      "Examples:\n  bin/optworker --port 3400\n  bin/optworker --host 10.0.0.5 --token SECRET --patience "
      "600");
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  if (name.empty()) {
    char host[64] = "";
    gethostname(host, sizeof host - 1);
    name = std::string(host) + '-' + std::to_string(getpid());
  }
  StopSignal stop;
  stop.catchSignals();
  const auto seconds = [] { return static_cast<double>(std::time(nullptr)); };
  for (double lost = -1;;) {
    try {
      FarmClient client(server, name, stop.fileDescriptor());
      lost = -1;
      work(client, stop);
      return 0;
    } catch (const Stopped&) {
      return 0;  // within a trial, which another worker gets
    } catch (const ConfigurationError&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {
      if (lost < 0) lost = seconds();
      if (stop.requested()) return 0;
      if (seconds() - lost >= patience) throw;
    }
    pollfd stopped{stop.fileDescriptor(), POLLIN, 0};
    poll(&stopped, 1, 200);
    if (stop.requested()) return 0;
  }
}

}  // namespace
}  // namespace plumbline

int main(int argc, char** argv) {
  return plumbline::guardedMain("optworker", plumbline::runProgram, argc, argv);
}
