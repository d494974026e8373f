#pragma once
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include "framework/WriteFile.h"
#include "simspark/ChildProcess.h"

namespace plumbline::bench {

/// Runs bin/gap diagnose on the runs in a folder, as a process that sees nothing else, unless the answer
/// exists. Stores the CPU seconds in a file next to it, unless the diagnosis was interrupted.
inline void diagnoseCase(const std::string& runs, const std::string& answer) {
  namespace fs = std::filesystem;
  if (fs::exists(answer)) return;
  const bool whole = !fs::exists(answer + ".searches");  // else it goes on from where another stopped
  simspark::ChildProcess child({"bin/gap", "diagnose", runs, "--json", answer, "--quiet", "--jobs", "1"},
                               "/dev/null");
  while (child.running()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  if (child.exitStatus() != 0)
    std::fprintf(stderr, "%s: bin/gap diagnose ended with %d\n", runs.c_str(),
                 child.exitStatus().value_or(-1));
  else if (whole)
    writeFile(answer + ".seconds", std::to_string(child.usage().cpuSeconds) + "\n");
}

/// CPU time that an answer took [s]; nothing where it was made in more than one go.
inline std::optional<double> secondsOf(const std::string& answer) {
  std::ifstream file(answer + ".seconds");
  double seconds = 0;
  if (file >> seconds) return seconds;
  return {};
}

}  // namespace plumbline::bench
