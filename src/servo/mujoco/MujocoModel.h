#pragma once
#include <string>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::servo::mujoco {

struct ModelOptions {
  bool freeBase = false;
  double step = 2e-4;             ///< [s]
  std::vector<bool> geared;       ///< per joint: a rotor of its own, joint `<name>.rotor`
  std::vector<double> armature;   ///< per joint [kg m^2]
  std::vector<double> damping;    ///< per joint, at the rotor [N m s/rad]
  std::vector<bool> hasFriction;  ///< per joint: dry friction at the rotor
  double groundFriction = 0.8;
  Vec3 slope = Vec3::Zero();   ///< rotation vector of the ground [rad]
  bool engineContacts = true;  ///< false: the ground's forces come from elsewhere
};

/// The robot as MuJoCo's XML: bodies by the links' names, joints by the joints', site `imu.gyro` and
/// `imu.acc`, geoms `sole.<foot>`. No joint limits: commands keep away from them.
std::string modelText(const Mechanism& robot, const ModelOptions& options);

}  // namespace plumbline::servo::mujoco
