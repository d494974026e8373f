#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace plumbline {

class TimingPlugin;
struct ThreadPlan;

/// A module as it runs.
struct ModuleReport {
  std::string name, area;             ///< area: "perception"; empty: none
  std::vector<std::string> provides;  ///< representations
  std::vector<std::string> reads;     ///< of REQUIRES and REQUIRES_IF_PROVIDED, where they are provided
  std::vector<std::string> uses;      ///< of USES
  double time = 0, wait = 0;          ///< work, and waiting for its input: means per cycle [us]
  std::uint64_t overruns = 0;         ///< cycles that ran over and in which a step of it took longest
};

/// A thread as it runs: its modules in the order of execution.
struct ThreadReport {
  struct Copy {
    std::string thread, representation;
  };
  std::string name;
  double load = 0, rate = 0;  ///< 0 .. 1, and the cycles per second that modules.cfg states; 0: none
  double time = 0;            ///< of a cycle without waiting, mean [us]
  std::uint64_t cycles = 0, overruns = 0;
  std::vector<Copy> copies;           ///< what comes from other threads
  std::vector<ModuleReport> modules;  ///< and special modules before them
};

/// May be called while the thread runs.
ThreadReport reportThread(const ThreadPlan& plan, const TimingPlugin& timing);

}  // namespace plumbline
