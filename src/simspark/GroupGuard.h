#pragma once
#include <sys/types.h>

namespace plumbline::simspark {

/// A small process that kills a group of processes once this process has ended, however it ended: for what a
/// child has started itself, which PR_SET_PDEATHSIG does not reach.
class GroupGuard {
public:
  /// Throws std::runtime_error "cannot guard processes: REASON".
  explicit GroupGuard(pid_t group);
  /// The group is guarded no longer, and stays as it is.
  ~GroupGuard();
  GroupGuard(const GroupGuard&) = delete;
  GroupGuard& operator=(const GroupGuard&) = delete;

  pid_t pid() const { return pid_; }

private:
  pid_t pid_ = -1;
  int end_ = -1;  ///< of the two sockets between this process and the guard
};

}  // namespace plumbline::simspark
