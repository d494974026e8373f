#include "ReplayReport.h"

#include <stdexcept>
#include <vector>

#include "simspark/LeagueRecording.h"
#include "simspark/LeagueRobots.h"
#include "simulation/replay/Fidelity.h"
#include "simulation/replay/TraceReplay.h"

namespace plumbline::simulation {

std::string replayReport(const std::string& file, std::optional<int> type, const WorldConfig& config) {
  const auto traces = simspark::readLeagueRecording(file);
  if (type && traces.size() > 1)
    throw std::runtime_error(file + ": is of " + std::to_string(traces.size()) +
                             " robots, whose types are in the names; leave --type out");
  std::vector<int> types;
  std::vector<RobotModel> models;
  for (const simspark::LeagueTrace& trace : traces) {
    const auto robotType = type ? type : trace.robotType;
    if (!robotType)
      throw std::runtime_error(file +
                               ": its name does not end with a robot type (_t0, _t1, ...): give --type");
    types.push_back(*robotType);
    models.push_back(simsparkRobot(*robotType));
  }
  const auto ours = replayTraces(traces, models, config);
  std::string report;
  for (std::size_t i = 0; i < traces.size(); ++i)
    report += (i > 0 ? "\n" : "") + fidelityReport(traces[i], ours[i], types[i]);
  return report;
}

}  // namespace plumbline::simulation
