#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "record/CdrStream.h"
#include "record/LogReader.h"

namespace plumbline {

/// The representations of one cycle of a log: that at a time of the log [s], or the last before it. Throws
/// std::runtime_error, one line, for a time outside the log.
class CycleOfLog {
public:
  CycleOfLog(record::LogReader& log, const record::LogReader::Thread& thread, double time);
  double time() const { return time_; }
  std::string path() const { return log_.path(); }

  /// Throws std::runtime_error, one line, for one that is missing or had other members.
  template <typename R>
  R get() const {
    const auto& loader = representationLoader<R>();
    R value;
    const std::string& message = messageOf(loader);
    const std::string error = message.empty() ? "no value yet" : record::readMessage<R>(message, value);
    const std::string problem = error.empty() ? loader.problemOf(value) : error;
    if (!problem.empty())
      throw std::runtime_error(
          fmt::format("{}: {} at {:.2f} s: {}", log_.path(), loader.name(), time_, problem));
    return value;
  }

private:
  /// Empty: there was no value yet.
  const std::string& messageOf(const RepresentationLoader& loader) const;

  record::LogReader& log_;
  const record::LogReader::Thread& thread_;
  std::vector<std::string> messages_;
  double time_ = 0;
};

}  // namespace plumbline
