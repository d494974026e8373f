#pragma once
#include <functional>
#include <string>
#include <vector>

#include "simspark/ChildProcess.h"
#include "simspark/StandardPorts.h"

namespace plumbline::simspark {

struct Ports {
  int agent = standardAgentPort;
  int monitor = standardMonitorPort;
  int web = 0;  ///< of its page; 0: it has none
};

/// The embedded simulator as a child process on free ports of the loopback interface.
class SimulatorProcess {
public:
  /// Starts `program` with `options` and waits until it has written its ports. `portsFile` is overwritten.
  /// Throws std::runtime_error if it can't be started or has no ports after ten seconds, or once `stopped`.
  SimulatorProcess(const std::string& program, std::vector<std::string> options, const std::string& portsFile,
                   const std::string& outputFile = "", const std::function<bool()>& stopped = {});

  const Ports& ports() const { return ports_; }
  ChildProcess& process() { return process_; }

private:
  ChildProcess process_;
  Ports ports_;
};

}  // namespace plumbline::simspark
