#include "simulation/server/Reports.h"

#include <algorithm>

#include "framework/WriteFile.h"
#include "simspark/NumberFormat.h"

namespace plumbline::simulation {

namespace {

std::string number(double value, int decimals) {
  std::string text;
  simspark::appendFixed(text, value, decimals);
  return text;
}

}  // namespace

void writePorts(const std::string& file, int agentPort, int monitorPort, int webPort, int fieldPort) {
  writeFile(file, "{\"agent\": " + std::to_string(agentPort) +
                      ", \"monitor\": " + std::to_string(monitorPort) +
                      (webPort > 0 ? ", \"web\": " + std::to_string(webPort) : "") +
                      (fieldPort > 0 ? ", \"field\": " + std::to_string(fieldPort) : "") + "}\n");
}

void writeStatistics(const std::string& file, const ServerStatistics& s) {
  const double cycles = static_cast<double>(std::max<std::uint64_t>(1, s.cycles));
  writeFile(file, "{\"cycles\": " + std::to_string(s.cycles) +
                      ", \"cpu_us_per_cycle\": " + number(s.cpuSeconds / cycles * 1e6, 2) +
                      ", \"sim_s\": " + number(s.simulatedSeconds, 2) +
                      ", \"wall_s\": " + number(s.wallSeconds, 3) + ", \"x_real_time\": " +
                      number(s.wallSeconds > 0 ? s.simulatedSeconds / s.wallSeconds : 0, 2) + "}\n");
}

}  // namespace plumbline::simulation
