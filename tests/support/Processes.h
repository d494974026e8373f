#pragma once
#include <sys/types.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "support/FarOff.h"

namespace plumbline {

/// Whether a process has ended. One that nobody has waited for yet has: an orphan's end may be noticed late.
inline bool processEnded(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  if (!std::getline(file, text)) return true;
  const std::size_t end = text.rfind(") ");
  return end == std::string::npos || text[end + 2] == 'Z' || text[end + 2] == 'X';
}

/// Waits for its end, at most so long [s]; false: it still runs.
inline bool processEnds(pid_t pid, double seconds = farOff) {
  for (int i = 0; i < static_cast<int>(200 * seconds); ++i) {
    if (processEnded(pid)) return true;
    usleep(5000);
  }
  return false;
}

}  // namespace plumbline
