#include "Diagnoses.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "framework/WriteFile.h"
#include "simspark/ChildProcess.h"

namespace plumbline::bench {

namespace {

std::string timeFile(const std::string& answer) { return answer + ".seconds"; }

}  // namespace

void diagnoseCase(const std::string& runs, const std::string& answer) {
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
    writeFile(timeFile(answer), std::to_string(child.usage().cpuSeconds) + "\n");
}

std::optional<double> secondsOf(const std::string& answer) {
  std::ifstream file(timeFile(answer));
  double seconds = 0;
  if (file >> seconds) return seconds;
  return {};
}

}  // namespace plumbline::bench
