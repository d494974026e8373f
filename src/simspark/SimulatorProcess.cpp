#include "simspark/SimulatorProcess.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/ReadFile.h"

namespace plumbline::simspark {

namespace {

std::vector<std::string> commandLine(const std::string& program, std::vector<std::string> options,
                                     const std::string& portsFile) {
  std::filesystem::remove(portsFile);
  options.insert(options.begin(), {program, "--port", "0", "--monitor-port", "0", "--ports-file", portsFile});
  return options;
}

}  // namespace

SimulatorProcess::SimulatorProcess(const std::string& program, std::vector<std::string> options,
                                   const std::string& portsFile, const std::string& outputFile,
                                   const std::function<bool()>& stopped)
    : process_(commandLine(program, std::move(options), portsFile), outputFile) {
  for (int i = 0; i < 2000; ++i) {
    if (std::filesystem::exists(portsFile)) {
      const auto ports = nlohmann::json::parse(readFile(portsFile, 1 << 20), nullptr, false);
      if (!ports.is_discarded() && ports.contains("agent") && ports.contains("monitor")) {
        ports_ = {ports["agent"].get<int>(), ports["monitor"].get<int>(), ports.value("web", 0)};
        return;
      }
    }
    if (stopped && stopped()) throw std::runtime_error("stopped before " + program + " listened");
    if (!process_.running())
      throw std::runtime_error(program + " ended with status " + std::to_string(*process_.exitStatus()) +
                               " before it listened" + (outputFile.empty() ? "" : "; see " + outputFile));
    usleep(5000);
  }
  throw std::runtime_error(program + " wrote no " + portsFile + " within 10 s");
}

}  // namespace plumbline::simspark
