#pragma once
#include <map>
#include <string>

namespace plumbline::bench {

struct Spread {
  double median = 0, least = 0, most = 0;
};

/// What evaluations of a task cost, all on the processor, of one core: waiting for the disk is not in it.
struct TaskSpeed {
  double farmed = 0;  ///< a run as users have it, median of the passes [s]
  Spread overhead{};  ///< of a pass: what the chain adds to the runs alone, as part of these
};
/// The same search in turn in this process alone and as bin/optserver and bin/optworker do it: through server
/// and client over TCP, with all results in a file and the history of a page.
TaskSpeed speedOf(const std::string& task, const std::map<std::string, std::string>& options, int generations,
                  int passes);

/// Where the time of a cycle of 20 ms of a robot that walks goes [s].
struct CycleTimes {
  double physics = 0, control = 0, walk = 0;
};
CycleTimes cycleTimes(int type, int cycles);

}  // namespace plumbline::bench
