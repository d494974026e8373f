#pragma once
#include <functional>
#include <string>
#include <vector>

#include "record/LogReader.h"

namespace plumbline::record {

/// Goes through a log once, cycle by cycle in the order in which they were written, and knows every value.
class LogWalk {
public:
  struct Step {
    std::size_t thread;
    const LogReader::Cycle* cycle;
    /// Of each topic, in this cycle; empty before its first.
    const std::vector<std::string>* messages;
    /// The topics with a message of their own in this cycle.
    const std::vector<std::size_t>* changed;
  };
  explicit LogWalk(LogReader& log);
  /// False: the log has ended.
  bool next(Step& step);
  /// Of all cycles.
  std::size_t done() const { return done_; }
  std::size_t total() const { return total_; }

private:
  LogReader& log_;
  std::vector<std::size_t> at_;
  std::vector<std::vector<std::string>> messages_;
  std::vector<std::size_t> changed_;
  std::size_t done_ = 0, total_ = 0;
};

}  // namespace plumbline::record
