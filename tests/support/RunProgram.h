#pragma once
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "simspark/ChildProcess.h"

namespace plumbline::bench {

/// Runs a program to its end, its output in a file. Throws std::runtime_error where its status is not 0.
inline void runProgram(const std::vector<std::string>& command, const std::string& log) {
  simspark::ChildProcess child(command, log);
  while (child.running()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (child.exitStatus() != 0)
    throw std::runtime_error(command[0] + " " + command[1] + " failed; see " + log);
}

}  // namespace plumbline::bench
