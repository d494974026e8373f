#pragma once
#include <optional>
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
  /// A message that starts with "warning: " or "error: ". A line of the source that warns more often than
  /// `perSecond` is kept back for the rest of the second; its next message says how many were.
  LogLine warning(const char* file = __builtin_FILE(), int line = __builtin_LINE());
  LogLine error(const char* file = __builtin_FILE(), int line = __builtin_LINE());
  static constexpr unsigned perSecond = 10;
  const std::string& source() const { return source_; }

private:
  LogLine limited(std::string_view start, const char* file, int line);

  std::string source_;
};

/// One message under way; it is written when the statement ends.
class LogLine {
public:
  /// keptBack: how many like it were not written before this; nothing: this is not written either.
  LogLine(const Log& log, std::string_view start, std::optional<unsigned> keptBack = 0);
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
  std::optional<unsigned> keptBack_;
};

template <typename T>
LogLine Log::operator<<(const T& value) {
  return LogLine(*this, value, 0);
}

}  // namespace plumbline
