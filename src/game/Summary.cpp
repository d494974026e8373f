#include "game/Summary.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace plumbline::game {

namespace {

double rounded(double value, double perUnit) { return std::round(value * perUnit) / perUnit; }

}  // namespace

std::string toJson(const Summary& summary) {
  nlohmann::ordered_json json;
  json["goal"] = summary.goal;
  json["goal_time_s"] = summary.goal ? nlohmann::ordered_json(rounded(summary.goalTime, 100)) : nullptr;
  json["falls"] = summary.falls;
  json["sim_time_s"] = rounded(summary.simTime, 100);
  json["wall_s"] = rounded(summary.wall, 1000);
  json["agent_cpu_us_per_cycle"] = rounded(summary.agentCpu, 10);
  json["simulator_cpu_us_per_cycle"] = rounded(summary.simulatorCpu, 10);
  return json.dump(2) + "\n";
}

}  // namespace plumbline::game
