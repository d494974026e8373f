#pragma once
#include <string>

namespace plumbline {

/// Watches the agent from a second process. When the agent dies by a signal, that process writes a file with
/// the signal's name, the step of each thread, the call stack and the last log messages. A normal end, Ctrl-C
/// and SIGTERM (see StopSignal::catchSignals) leave no file.
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

private:
  std::string path_;
};

}  // namespace plumbline
