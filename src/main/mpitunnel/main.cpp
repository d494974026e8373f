#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "MpiTransport.h"
#include "framework/CommandLine.h"
#include "framework/GuardedMain.h"
#include "framework/SingleLine.h"
#include "framework/StopSignal.h"
#include "tunnel/ServerRank.h"
#include "tunnel/WorkerRank.h"

namespace plumbline {
namespace {

constexpr int failed = tunnel::Watchdog::failed;
constexpr int farewell = 5;  // [s]

/// Takes what follows the first and the second "--".
void takeCommands(int argc, char** argv, int& ownCount, tunnel::TunnelOptions& options) {
  const std::string dashes = "--";
  char** const end = argv + argc;
  char** const first = std::find(argv, end, dashes);
  ownCount = static_cast<int>(first - argv);
  if (first == end) return;
  char** const second = std::find(first + 1, end, dashes);
  options.server.assign(first + 1, second);
  if (second != end) options.worker.assign(second + 1, end);
}

tunnel::RankEnd runRank(MpiTransport& transport, const tunnel::TunnelOptions& options,
                        const StopSignal& stop) {
  std::unique_ptr<tunnel::TunnelRank> rank;
  if (transport.rank() == 0)
    rank = std::make_unique<tunnel::ServerRank>(transport, options);
  else
    rank = std::make_unique<tunnel::WorkerRank>(transport, options);
  return rank->run(stop);
}

int runProgram(int argc, char** argv) {
  tunnel::TunnelOptions options;
  CommandLine app(
      "Carries TCP connections over MPI: a server on one node of a cluster, its clients on others.",
      "mpitunnel");
  app.option("--port", options.port,
             "The server's port on loopback; 0: a free one, which {port} passes to it")
      .portOrFree()
      .showDefault();
  app.option("--patience", options.patience, "Waits so long for the server to open its port [s]")
      .range(0.0, 1e6)
      .showDefault();
  app.option("--grace", options.grace, "A worker may go on for so long once the server has ended [s]")
      .range(0.0, 3600.0)
      .showDefault();
  app.option("--silence", options.silence,
             "A rank that says nothing for so long has gone, which ends all [s]")
      .range(1.0, 3600.0)
      .showDefault();
  app.flag("--again", options.again, "A worker that fails is started again, once a second");
  app.footer(
      "mpirun -n RANKS bin/mpitunnel [OPTIONS] -- SERVER [ARGUMENT]... -- WORKER [ARGUMENT]...\n"
      "Rank 0 runs SERVER, every other rank WORKER, which finds the server at a port of its own loopback.\n"
      "In the commands {port} is the port on loopback and {rank} the number of the rank; the variables "
      "MPITUNNEL_PORT\n"
      "and MPITUNNEL_RANK are the same. The exit status is the server's. Ctrl-C ends all that was started.\n"
      "Examples:\n"
      "  mpirun -n 4 bin/mpitunnel -- bin/optserver study.yaml --port {port} -- bin/optworker --port {port}\n"
      "  mpirun -n 8 bin/mpitunnel --port 3400 --again -- bin/optserver study.yaml -- bin/optworker --port "
      "{port}");
  int ownCount = argc;
  takeCommands(argc, argv, ownCount, options);
  if (const auto status = readCommandLine(app, ownCount, argv)) return *status;
  if (options.server.empty() || options.worker.empty()) {
    const std::string missing = fmt::format("the {} command is missing: -- SERVER -- WORKER",
                                            options.server.empty() ? "server's" : "worker's");
    std::fprintf(stderr, "mpitunnel: %s\n", commandLineError(app, missing).c_str());
    return failed;
  }
  MpiTransport transport(argc, argv);
  if (transport.ranks() < 2) {
    std::fprintf(stderr, "mpitunnel: one rank alone has nobody to carry anything to: mpirun -n 2 or more\n");
    transport.leave(farewell, failed);
    return failed;
  }
  StopSignal stop;
  stop.catchSignals();
  try {
    const tunnel::RankEnd end = runRank(transport, options, stop);
    if (!end.early) {
      transport.leave(farewell, end.status);
      return end.status;
    }
    if (transport.rank() == 0)
      std::fprintf(stderr, "mpitunnel: %s\n",
                   stop.requested() ? stop.reason().c_str() : "a rank failed or was stopped, and so all end");
    std::fflush(nullptr);
    _exit(end.status);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mpitunnel: rank %d: %s\n", transport.rank(), errorLine(error).c_str());
    transport.abort(failed);
  }
}

}  // namespace
}  // namespace plumbline

int main(int argc, char** argv) {
  return plumbline::guardedMain("mpitunnel", plumbline::runProgram, argc, argv);
}
