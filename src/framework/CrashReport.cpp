#include "framework/CrashReport.h"

#include <execinfo.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>

namespace plumbline {

const char* signalName(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "SIGSEGV";
    case SIGBUS:
      return "SIGBUS";
    case SIGFPE:
      return "SIGFPE";
    case SIGILL:
      return "SIGILL";
    case SIGABRT:
      return "SIGABRT";
    case SIGSYS:
      return "SIGSYS";
    case SIGTRAP:
      return "SIGTRAP";
    case SIGQUIT:
      return "SIGQUIT";
    case SIGXCPU:
      return "SIGXCPU";
    case SIGPIPE:
      return "SIGPIPE";
    default:
      return "a signal";
  }
}

bool writeCrashReport(const CrashRecord& record, pid_t agent, const std::string& path) {
  const int signal = record.signal;
  char date[64] = "";
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  std::strftime(date, sizeof(date), "%Y-%m-%d %H:%M:%S UTC", gmtime_r(&now, &utc));
  const std::string partial = path + ".part" + std::to_string(agent);
  std::ofstream stream(partial);
  if (signal != 0) {
    stream << "Process " << agent << " died by " << signalName(signal) << " (" << strsignal(signal) << "), "
           << date << ".\n";
  } else {
    stream << "Process " << agent << " was killed by a signal that it cannot catch (SIGKILL), " << date
           << ":\nby hand, by the program that started it, or by Linux because memory was short.\n";
  }
  stream << "\nThreads:\n" << record.whereabouts();
  const int calls = std::clamp<int>(record.callCount, 0, static_cast<int>(record.calls.size()));
  if (calls > 0) {
    // This process has the agent's memory layout: the same program, forked.
    char** names = backtrace_symbols(record.calls.data(), calls);
    stream << "\nCalls, innermost first (addr2line -e PROGRAM +0x... gives the line):\n";
    for (int i = 0; names && i < calls; ++i) stream << names[i] << "\n";
    std::free(names);
  }
  stream << "\nLast messages, oldest first:\n" << record.lastMessages();
  stream.close();
  if (stream && std::rename(partial.c_str(), path.c_str()) == 0) return true;
  std::remove(partial.c_str());
  return false;
}

}  // namespace plumbline
