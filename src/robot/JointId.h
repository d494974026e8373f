#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace plumbline {

/// Joints of a humanoid by the NAO's names and signs: torso frame x forward, y left, z up, right-hand rule;
/// positive pitch turns the moving part forward and down, a bent knee is positive. SimSpark has one hip
/// yaw-pitch per leg and, in type 4, toes; a robot lacks a joint if RobotModel::linkOfJoint is -1.
enum JointId : int {
  headYaw,
  headPitch,
  lShoulderPitch,
  lShoulderRoll,
  lElbowYaw,
  lElbowRoll,
  rShoulderPitch,
  rShoulderRoll,
  rElbowYaw,
  rElbowRoll,
  lHipYawPitch,
  lHipRoll,
  lHipPitch,
  lKneePitch,
  lAnklePitch,
  lAnkleRoll,
  lToePitch,
  rHipYawPitch,
  rHipRoll,
  rHipPitch,
  rKneePitch,
  rAnklePitch,
  rAnkleRoll,
  rToePitch,
  numJoints
};

constexpr std::array<std::string_view, numJoints> jointNames = {
    "HeadYaw",        "HeadPitch",     "LShoulderPitch", "LShoulderRoll", "LElbowYaw",    "LElbowRoll",
    "RShoulderPitch", "RShoulderRoll", "RElbowYaw",      "RElbowRoll",    "LHipYawPitch", "LHipRoll",
    "LHipPitch",      "LKneePitch",    "LAnklePitch",    "LAnkleRoll",    "LToePitch",    "RHipYawPitch",
    "RHipRoll",       "RHipPitch",     "RKneePitch",     "RAnklePitch",   "RAnkleRoll",   "RToePitch"};

enum class Side { left, right };

/// The leg's first joint; the leg's joints follow in the order of JointId.
constexpr JointId firstLegJoint(Side side) { return side == Side::left ? lHipYawPitch : rHipYawPitch; }

/// One value per joint [rad, rad/s, ... as the name of the variable says].
using JointArray = std::array<double, numJoints>;

/// The joint of that name, or numJoints if there is none.
constexpr JointId jointByName(std::string_view name) {
  for (std::size_t i = 0; i < jointNames.size(); ++i)
    if (jointNames[i] == name) return static_cast<JointId>(i);
  return numJoints;
}

}  // namespace plumbline
