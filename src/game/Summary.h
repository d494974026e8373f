#pragma once
#include <string>

namespace plumbline::game {

/// The result of a run; the content of summary.json.
struct Summary {
  bool goal = false;
  double goalTime = 0;  ///< game clock at the goal [s]; meaningless without one
  int falls = 0;
  double simTime = 0;       ///< simulated [s]
  double wall = 0;          ///< real time [s]
  double agentCpu = 0;      ///< of the agent's process [us per cycle]
  double simulatorCpu = 0;  ///< [us per cycle]
  bool over = false;        ///< a goal or the time was up; false: it was stopped
};

/// {"goal": ..., "goal_time_s": ... or null, "falls", "sim_time_s", "wall_s", "agent_cpu_us_per_cycle",
/// "simulator_cpu_us_per_cycle"} and a newline.
std::string toJson(const Summary& summary);

}  // namespace plumbline::game
