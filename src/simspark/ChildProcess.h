#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace plumbline::simspark {

/// CPU time a process has used, and its largest resident memory, as the kernel counted them.
struct ProcessUsage {
  double cpuSeconds = 0;
  double maxResidentMegabytes = 0;
};

/// A program started as a child: it is told to stop when this object ends and dies with this process
/// (PR_SET_PDEATHSIG), so nothing is left behind.
class ChildProcess {
public:
  /// Starts argv[0] (a path) with these arguments; its standard output and error go to `outputFile`
  /// (appended), or are inherited if that is empty. Throws std::runtime_error "cannot start PATH: REASON".
  explicit ChildProcess(const std::vector<std::string>& argv, const std::string& outputFile = "");
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t pid() const { return pid_; }
  /// False once it has ended (reaps it).
  bool running();
  /// Exit status, or 128 + signal; empty while it runs.
  std::optional<int> exitStatus() const { return exitStatus_; }
  /// SIGTERM, then SIGKILL after `patienceSeconds`; returns when it has ended.
  void stop(double patienceSeconds = 2.0);
  /// Of a process that has ended.
  ProcessUsage usage() const { return usage_; }

private:
  bool reap(int options);

  pid_t pid_ = -1;
  std::optional<int> exitStatus_;
  ProcessUsage usage_;
};

}  // namespace plumbline::simspark
