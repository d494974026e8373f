#include "simulation/replay/TraceReplay.h"

#include <stdexcept>

#include "simulation/replay/BallStart.h"
#include "simulation/replay/ReplayedRobots.h"
#include "simulation/replay/StartFit.h"

namespace plumbline::simulation {

using simspark::LeagueTrace;
using simspark::TraceRow;

std::vector<std::vector<TraceRow>> replayTraces(const std::vector<LeagueTrace>& traces,
                                                const std::vector<RobotModel>& models,
                                                const WorldConfig& config) {
  if (traces.empty() || models.size() != traces.size())
    throw std::invalid_argument("replay: each robot of the recording needs its model");
  for (const LeagueTrace& trace : traces)
    if (trace.rows.size() != traces[0].rows.size())
      throw std::invalid_argument("replay: all robots of a recording need as many rows");
  const BodyState ball = ballAfterOneStep(ballBefore(traces[0], 0, config), config);
  const std::vector<StartState> starts = fitStarts(traces, models, ball, config);
  ReplayedRobots robots(traces, models, starts, ball, config);
  World& world = robots.world();
  const LeagueTrace& first = traces.front();
  std::vector<std::vector<TraceRow>> rows(traces.size());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    if (i > 0) {
      robots.act(i);
      if (ballJumps(first, i)) world.setBall(ballBefore(first, i, config));
      world.step();
    }
    for (std::size_t r = 0; r < traces.size(); ++r) rows[r].push_back(robots.sense(r, i));
  }
  return rows;
}

std::vector<TraceRow> replayTrace(const LeagueTrace& trace, const RobotModel& model,
                                  const WorldConfig& config) {
  return replayTraces(std::vector{trace}, std::vector{model}, config).front();
}

}  // namespace plumbline::simulation
