#pragma once
#include <vector>

#include "robot/RobotModel.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// The robot with what effects change of its links.
RobotModel withEffects(RobotModel model, const std::vector<EffectSetting>& effects);

/// A joint motor's torque limit [N m] with what effects change of it; never below 0.
double motorTorque(double nominal, JointId joint, const std::vector<EffectSetting>& effects);

}  // namespace plumbline::simulation
