#pragma once
#include <atomic>
#include <mutex>
#include <string>

namespace plumbline {

/// The request to end an agent, made once by a module, main or a signal and seen by all threads.
class StopSignal {
public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// The first request decides what the agent returns and says; later ones are dropped.
  void request(int exitCode, const std::string& reason);
  bool requested() const { return requested_.load(std::memory_order_relaxed); }
  /// Readable (poll, select) from the request on: for modules that wait for something else.
  int fileDescriptor() const { return descriptor_; }
  int exitCode() const;
  std::string reason() const;

  /// Ctrl-C, SIGTERM and SIGHUP request the stop (exit code 0) of this signal until it is destroyed; a second
  /// one ends the process at once.
  void catchSignals();

private:
  static void handle(int signal);

  std::atomic<bool> requested_{false};
  int descriptor_;
  mutable std::mutex mutex_;
  bool decided_ = false;
  int exitCode_ = 0;
  std::string reason_;
};

}  // namespace plumbline
