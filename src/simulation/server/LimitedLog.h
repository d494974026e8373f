#pragma once
#include <functional>
#include <string>

#include "framework/RepeatLimit.h"

namespace plumbline::simulation {

/// Receives one line about something worth knowing.
using LogFunction = std::function<void(const std::string&)>;

/// Passes on lines with a limit: lines that differ only in addresses at most some times a second, then their
/// number. Bytes from a client are made printable.
class LimitedLog {
public:
  static constexpr unsigned perSecond = 30;

  explicit LimitedLog(LogFunction log) : log_(std::move(log)) {}
  LimitedLog(const LimitedLog&) = delete;
  LimitedLog& operator=(const LimitedLog&) = delete;

  void operator()(const std::string& line);
  /// Says of how many lines it said nothing; to be called now and then.
  void reportOverdue();

private:
  LogFunction log_;
  RepeatLimit limit_{perSecond};
};

}  // namespace plumbline::simulation
