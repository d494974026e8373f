#pragma once
#include <string>

#include "simulation/server/Server.h"

namespace plumbline::simulation {

// Small files for the caller of the simulator, written whole (framework/WriteFile.h): nobody reads half of
// one, nor is one empty after a loss of power. Each throws std::runtime_error, one line, if it cannot be
// written.

/// {"agent": 3100, "monitor": 3200}, and "web": 8080 if there is a page, "field": 3201 if bin/simplemonitor
/// has its port.
void writePorts(const std::string& file, int agentPort, int monitorPort, int webPort = 0, int fieldPort = 0);
/// {"cycles":, "cpu_us_per_cycle":, "sim_s":, "wall_s":, "x_real_time":}
void writeStatistics(const std::string& file, const ServerStatistics& statistics);

}  // namespace plumbline::simulation
