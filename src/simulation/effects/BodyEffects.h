#pragma once
#include <vector>

#include "robot/RobotModel.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// The robot with link_mass, com_offset, speed_limit and supply_voltage in it. A link's added mass sits at
/// its centre of mass; a link keeps a gram at least.
RobotModel withEffects(RobotModel model, const std::vector<EffectSetting>& effects);

/// A joint motor's torque limit [N m] with torque_limit and supply_voltage, less what coulomb_friction takes:
/// a velocity motor feels friction as torque that it lacks.
double motorTorque(double nominal, JointId joint, const std::vector<EffectSetting>& effects);

}  // namespace plumbline::simulation
