#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace plumbline {

/// Reports the progress of long work on standard error, with or without a terminal: first after `first`
/// seconds, then every `interval`: `PROGRAM: STAGE: 12 %, about 3 min left`. It has its own thread, so that a
/// slow step does not look like a hang. The clock affects only these lines.
class ProgressReport {
public:
  using Seconds = std::chrono::duration<double>;
  /// No program that works is silent for longer where there is no terminal.
  static constexpr Seconds longestSilence{10};
  explicit ProgressReport(std::string program, Seconds first = Seconds(5), Seconds interval = longestSilence);
  ~ProgressReport();
  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  /// What is being done and which share of it is done, 0 .. 1; below 0: nobody knows. From any thread.
  void update(const std::string& stage, double share = -1);

private:
  void run(Seconds first, Seconds interval);
  std::string line() const;

  const std::string program_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  bool end_ = false;
  std::string stage_;
  double share_ = -1, firstShare_ = -1;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::jthread thread_;
};

/// "40 s", "12 min", "3.5 h".
std::string durationText(double seconds);

}  // namespace plumbline
