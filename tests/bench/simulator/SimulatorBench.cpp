// What the embedded simulator costs, beside the league's server, per number of robots. Needs bin/simulator
// and bin/agent. Argument: cycles with one robot (15000).
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

#include "Figures.h"

namespace plumbline::bench {

namespace {
double seconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
}  // namespace

double cpuMicroseconds() { return 1e6 * seconds(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace plumbline::bench

int main(int argc, char** argv) {
  using namespace plumbline::bench;
  try {
    Figures figures;
    measureCrowds(figures, argc > 1 ? std::atoi(argv[1]) : 15000);
    measureGames(figures);
    measureParts(figures);
    measureWire(figures);
    std::ofstream("build/bench/simulator.json") << figures.all.dump(1) << '\n';
    for (const json& f : figures.all)
      std::printf("%-44s %10.2f %s\n", f["name"].get<std::string>().c_str(), f["value"].get<double>(),
                  f["unit"].get<std::string>().c_str());
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "SimulatorBench: %s\n", problem.what());
    return 1;
  }
}
