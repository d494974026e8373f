#pragma once
#include <map>
#include <string>

namespace plumbline::bench {

/// What evaluations of a task cost, all on the processor, of one core.
struct TaskSpeed {
  double bare = 0;  ///< a run in this process [s]
  double farmed =
      0;  ///< a run of the same search through server and client over TCP, and what they compute [s]
};
TaskSpeed speedOf(const std::string& task, const std::map<std::string, std::string>& options,
                  int generations);

/// Where the time of a cycle of 20 ms of a robot that walks goes [s].
struct CycleTimes {
  double physics = 0, control = 0, walk = 0;
};
CycleTimes cycleTimes(int type, int cycles);

}  // namespace plumbline::bench
