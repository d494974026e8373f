#pragma once
#include <atomic>

namespace plumbline::tunnel {

/// SIGCONT, which goes on with a process that was stopped, and which mpirun also sends a second before it
/// ends its ranks by SIGTERM and SIGKILL.
class ContinueSignal {
public:
  /// It is counted from here on, and wakes poll().
  ContinueSignal();
  /// Whether it has come since this was asked last.
  bool came();

private:
  static void count(int) { counted_.fetch_add(1, std::memory_order_relaxed); }
  static inline std::atomic<unsigned> counted_{0};

  unsigned seen_ = 0;
};

}  // namespace plumbline::tunnel
