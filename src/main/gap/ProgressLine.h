#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace plumbline::gap {

/// Shows progress on standard error: in a terminal a line that is rewritten in place, elsewhere a new line
/// every 10 s, "gap: STAGE: 34 %, 120 s". The time continues even without new progress, so that long work
/// never seems to hang. Thread-safe.
class ProgressLine {
public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void update(const std::string& what, double share);
  /// Prints a message that the line does not overwrite, even if quiet.
  void say(const std::string& text);

private:
  using Clock = std::chrono::steady_clock;
  void write();  ///< with the mutex held
  void clear();

  const bool shown_, inPlace_;
  const Clock::time_point begin_ = Clock::now();
  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::string stage_;
  double done_ = 0;
  Clock::time_point last_ = begin_;
  std::jthread ticker_;
};

}  // namespace plumbline::gap
