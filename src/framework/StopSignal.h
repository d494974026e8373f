#pragma once
#include <atomic>
#include <mutex>
#include <string>
#include <utility>

namespace plumbline {

/// Thrown from within long work that a person ended. It is not a std::exception, so that code which continues
/// after an error does not continue after this. Main prints what() and ends.
class Stopped {
public:
  explicit Stopped(std::string text = "stopped; nothing was written") : text_(std::move(text)) {}
  const std::string& what() const { return text_; }

private:
  std::string text_;
};

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

  /// Ctrl-C, SIGTERM and SIGHUP request the stop (exit code 0) of this signal until it is destroyed. A second
  /// one ends the process at once, unless it comes within 0.3 s: then it is the same wish once more.
  void catchSignals();
  /// Throws Stopped once a signal that is caught has come: for the innermost loops of long work. Costs a
  /// read.
  static void throwIfCaught() {
    if (caughtSignal.load(std::memory_order_relaxed) != 0) throw Stopped();
  }
  /// The fileDescriptor() of the StopSignal that catches signals now; -1: none does. For waits deep within
  /// long work, as throwIfCaught() is for its loops.
  static int caughtDescriptor();

private:
  static void handle(int signal);

  static inline std::atomic<int> caughtSignal{0};

  std::atomic<bool> requested_{false};
  int descriptor_;
  mutable std::mutex mutex_;
  bool decided_ = false;
  int exitCode_ = 0;
  std::string reason_;
};

}  // namespace plumbline
