#pragma once
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "framework/StopSignal.h"
#include "tunnel/ContinueSignal.h"

namespace plumbline::tunnel {

/// Ends this process where its loop does not: MPI waits for ever for a rank that has gone. What a
/// ChildProcess started with its whole group ends with it.
class Watchdog {
public:
  /// How long ending may take [s], and the status of one that was asked to stop.
  static constexpr double patience = 0.6;
  static constexpr int stopped = 130, failed = 2;

  /// A loop that is not asked to stop may be silent for `silence` seconds; what it waits for is not counted
  /// while the process is stopped.
  Watchdog(const StopSignal& stop, double silence);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// The loop goes on.
  void beat() { beats_.fetch_add(1, std::memory_order_relaxed); }
  /// It ends now, with this status.
  void ending(int status) { status_.store(status); }

private:
  void watch(const StopSignal& stop, double silence);

  std::atomic<unsigned> beats_{0};
  std::atomic<int> status_{-1};
  ContinueSignal continued_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace plumbline::tunnel
