#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/RepresentationLoader.h"
#include "record/LogReader.h"

namespace plumbline {
struct ThreadPlan;
}

namespace plumbline::record {

/// Provides representations of one thread from a log, cycle by cycle. A module that reads a representation
/// which in the recorded cycle was updated after it (USES) gets that of the cycle before, as it did then.
class ReplayPlayer {
public:
  /// The recorded thread of that name, or the only one there is. Throws std::runtime_error, one line.
  ReplayPlayer(const std::string& path, const std::string& thread);

  /// Fills `target` from now on. Throws std::runtime_error if the log does not have the representation, or
  /// has it with other members.
  void provide(const RepresentationLoader& loader, Representation& target);
  /// The modules that run, when all that is provided is known.
  void plan(const ThreadPlan& plan);

  std::vector<std::int64_t> timestamps() const;
  const LogReader::Thread& recorded() const { return thread_; }
  std::size_t played() const { return played_; }
  bool atEnd() const { return played_ == thread_.cycles.size(); }

  void restart() { played_ = 0; }
  /// Takes the next cycle: the representations at its start.
  void begin();
  /// Before the module of that index in the plan executes.
  void beforeModule(std::size_t index) {
    if (!late_.empty()) applyBefore(index);
  }
  /// Sets what comes after all modules.
  void end();

private:
  struct Topic {
    Representation* target = nullptr;  ///< null: not provided
    bool late = false;
    std::string waiting;  ///< its message of this cycle, while it is late
    bool waits = false;
  };

  void apply(std::size_t topic, std::string_view message);
  void applyBefore(std::size_t index);
  void applyWaiting(std::size_t topic);

  LogReader reader_;
  const LogReader::Thread& thread_;
  std::vector<Topic> topics_;
  std::vector<std::vector<std::size_t>> late_;  ///< topics before each module; behind the last: at the end
  std::size_t played_ = 0;
};

}  // namespace plumbline::record
