#pragma once
#include <sys/types.h>

#include <chrono>

namespace plumbline::simspark {

/// How long a process is given to end. On a busy machine it may be ready to run, but others have the
/// processor: then only what it runs counts, also while it waits for a disk. A process that hangs, computes
/// without end or was stopped (SIGSTOP) has the time of a clock. After 30 s it is over in any case.
class Patience {
public:
  Patience(pid_t process, double seconds);
  /// Asked again and again, every few milliseconds.
  bool isOver();

private:
  using Clock = std::chrono::steady_clock;

  const pid_t process_;
  double left_;
  double ran_;  ///< what its threads had run at the last look [s]
  const Clock::time_point begin_;
  Clock::time_point looked_;
};

}  // namespace plumbline::simspark
