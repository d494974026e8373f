#pragma once
#include <string>

namespace plumbline {

/// Watches the agent from a second process. When the agent dies by a signal, also SIGKILL, that process
/// writes a file with the signal's name, the step of each thread, the call stack and the last log messages. A
/// normal end, Ctrl-C and SIGTERM (see StopSignal::catchSignals) leave no file, nor does the death of the
/// program that has started the agent and takes it along (PR_SET_PDEATHSIG).
class CrashLog {
public:
  /// Starts the second process. At the beginning of main, before any thread; one at a time. If that is not
  /// possible there will be no crash log, and the log says so. An agent that was struck by a signal is gone
  /// after `secondsToDie`, whatever it or the second process hang on.
  explicit CrashLog(const std::string& path = "crash.log", unsigned secondsToDie = 30);
  /// The agent ends in order: ends the second process and waits for it.
  ~CrashLog();
  CrashLog(const CrashLog&) = delete;
  CrashLog& operator=(const CrashLog&) = delete;

  /// Lets a stack overflow of the calling thread be caught, too. Process does this for an agent's threads.
  static void protectThread();

  /// The process ends now, as somebody wants it to or after it has said why: there will be no file. Safe in a
  /// signal handler; nothing without a crash log.
  static void giveUp() noexcept;

private:
  std::string path_;
};

}  // namespace plumbline
