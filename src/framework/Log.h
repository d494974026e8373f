#pragma once
#include <ostream>
#include <string>
#include <string_view>

namespace plumbline {

class LogLine;

/// A module's log. Each statement is one message:
///
///     log << "ball at " << x << " m";
///     log.warning() << "no ball for " << seconds << " s";
///
/// Messages go into a ring in memory that crash.log is written from, and to standard output with -v.
/// (In a module, the logarithm is std::log.)
class Log {
public:
  explicit Log(std::string source) : source_(std::move(source)) {}

  template <typename T>
  LogLine operator<<(const T& value);
  LogLine operator<<(std::ostream& (*manipulator)(std::ostream&));
  /// A message that starts with "warning: " or "error: ".
  LogLine warning();
  LogLine error();
  const std::string& source() const { return source_; }

private:
  std::string source_;
};

/// One message under way; it is written when the statement ends.
class LogLine {
public:
  LogLine(const Log& log, std::string_view start);
  template <typename T>
  LogLine(const Log& log, const T& value, int) : LogLine(log, std::string_view()) {
    stream_ << value;
  }
  LogLine(const LogLine&) = delete;
  LogLine& operator=(const LogLine&) = delete;
  ~LogLine();

  template <typename T>
  LogLine& operator<<(const T& value) {
    stream_ << value;
    return *this;
  }
  LogLine& operator<<(std::ostream& (*manipulator)(std::ostream&)) {
    manipulator(stream_);
    return *this;
  }

private:
  const Log& log_;
  std::ostream& stream_;
};

template <typename T>
LogLine Log::operator<<(const T& value) {
  return LogLine(*this, value, 0);
}

}  // namespace plumbline
