#pragma once
#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simspark/GroupGuard.h"
#include "simspark/Patience.h"

namespace plumbline::simspark {

/// CPU time a process has used, and its largest resident memory, as the kernel counted them.
struct ProcessUsage {
  double cpuSeconds = 0;
  double maxResidentMegabytes = 0;
};

/// How a child is started.
struct ChildSettings {
  std::string outputFile{};                ///< where its output and errors are appended; empty: inherited
  std::vector<std::string> environment{};  ///< NAME=VALUE, in place of or besides what is inherited
  std::vector<std::string> dropped{};      ///< what begins with one of these is not inherited
  bool onPath = false;                     ///< a name without '/' is looked for on PATH
  /// What it starts itself ends with it: when it has ended, and when this process has, even by SIGKILL.
  bool wholeGroup = false;
};

/// A program started as a child, the leader of a process group of its own: it gets SIGTERM when this
/// object ends and dies with this process (PR_SET_PDEATHSIG), so nothing is left behind.
class ChildProcess {
public:
  /// Starts argv[0] (a path) with these arguments; its standard output and error go to `outputFile`
  /// (appended), or are inherited if that is empty. Throws std::runtime_error "cannot start PATH: REASON".
  explicit ChildProcess(const std::vector<std::string>& argv, const std::string& outputFile = "")
      : ChildProcess(argv, ChildSettings{.outputFile = outputFile}) {}
  ChildProcess(const std::vector<std::string>& argv, const ChildSettings& settings);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t pid() const { return pid_; }
  /// False once it has ended (reaps it).
  bool running();
  /// Exit status, or 128 + signal; empty while it runs.
  std::optional<int> exitStatus() const { return exitStatus_; }
  /// To it and to all of its group; nothing once it has ended.
  void signalGroup(int signal);
  /// SIGTERM; from now on it has `patienceSeconds` (see Patience) until stop() kills it. Of several children
  /// all are asked before stop() waits for the first: then their times pass together.
  void askToStop(double patienceSeconds = 0.7);
  /// Asks it unless that was done, then SIGKILL once its patience is over; to its group if that is its whole.
  /// Returns when it has ended; one that was killed leaves its group a quarter of a second to end, too.
  void stop(double patienceSeconds = 0.7);
  /// Of a process that has ended.
  ProcessUsage usage() const { return usage_; }

private:
  bool reap(int options);
  void sendSignal(int signal);

  pid_t pid_ = -1;
  bool wholeGroup_;
  std::unique_ptr<GroupGuard> guard_;
  std::optional<Patience> patience_;  ///< from the time at which it was asked to stop
  std::optional<int> exitStatus_;
  ProcessUsage usage_;
};

}  // namespace plumbline::simspark
