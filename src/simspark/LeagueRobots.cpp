#include "simspark/LeagueRobots.h"

#include <filesystem>

#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "framework/SingleLine.h"
#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"

namespace plumbline {

namespace {

std::string fileOf(int type) { return configPath("robots/" + simsparkRobotName(type) + ".json"); }

std::vector<RobotModel> readAll() {
  std::vector<RobotModel> robots;
  std::error_code none;
  try {
    for (int type = 0; type < maxSimsparkTypes && std::filesystem::exists(fileOf(type), none); ++type)
      robots.push_back(Humanoid(readMechanism(fileOf(type))).model());
  } catch (const std::exception& error) {
    throw ConfigurationError(errorLine(error));
  }
  if (robots.empty())
    throw ConfigurationError(fileOf(0) + ": is missing; the league's robot types begin with this file");
  return robots;
}

}  // namespace

std::string simsparkRobotName(int type) { return "simspark_type" + std::to_string(type); }

const std::vector<RobotModel>& simsparkRobots() {
  static const std::vector<RobotModel> robots = readAll();
  return robots;
}

int numSimsparkTypes() { return static_cast<int>(simsparkRobots().size()); }

const RobotModel& simsparkRobot(int type) {
  if (type < 0 || type >= numSimsparkTypes())
    throw ConfigurationError("there is no robot type " + std::to_string(type) + "; " + configPath("robots") +
                             " has the league's types 0 to " + std::to_string(numSimsparkTypes() - 1) +
                             ", the next one is a file " + simsparkRobotName(numSimsparkTypes()) +
                             ".json there");
  return simsparkRobots()[static_cast<std::size_t>(type)];
}

}  // namespace plumbline
