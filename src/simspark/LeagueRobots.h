#pragma once
#include <string>
#include <vector>

#include "robot/RobotModel.h"

namespace plumbline {

/// A monitor's scene has one digit for the type.
constexpr int maxSimsparkTypes = 10;

/// The league's robot types, by the number that the wire has for them: config/robots/simspark_type0.json and
/// so on, as many as follow each other, at most maxSimsparkTypes. They are read once, when they are first
/// asked for. Throws ConfigurationError for files that cannot be used.
const std::vector<RobotModel>& simsparkRobots();

/// How many there are.
int numSimsparkTypes();

/// One of them. Throws ConfigurationError for another number; the text says which there are.
const RobotModel& simsparkRobot(int type);

/// The name of a type's file: "simspark_type3".
std::string simsparkRobotName(int type);

}  // namespace plumbline
