// The walk measured: speeds and falls of all robot types, the tables and figures of the thesis, pushes, the
// velocity estimate and the cost. Prints tables; writes build/bench/walking.json, walking.md and
// walking.html. Arguments: seeds (10), minutes of random requests per type and seed (3), tries of a push
// (100).
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "bench/walking/Sections.h"

int main(int argc, char** argv) {
  using namespace plumbline::bench;
  BenchSetup setup;
  if (argc > 1) setup.seeds = std::max(2, std::atoi(argv[1]));
  if (argc > 2) setup.minutes = std::max(0.1, std::atof(argv[2]));
  if (argc > 3) setup.tries = std::max(20, std::atoi(argv[3]));
  try {
    Report report;
    Page page;
    page.title = "The walk, measured";
    page.introduction =
        "Figures of chapter 4 of the thesis (Seekircher 2015) drawn from this walk in the embedded "
        "simulator; "
        "written by make bench-walking.";
    measureSpeeds(setup, report);
    measureThesisTables(setup, report, page);
    measurePushes(setup, report);
    measureEstimate(setup, report, page);
    writeFile("build/bench/walking.json", report.json());
    writeFile("build/bench/walking.md", report.tables());
    writeFile("build/bench/walking.html", page.html());
  } catch (const std::exception& error) {
    fmt::print(stderr, "walking benchmark: {}\n", error.what());
    return 2;
  }
  return 0;
}
