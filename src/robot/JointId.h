#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace plumbline {

/// Number of a joint, resolved from its name when a robot is loaded (RobotModel::joint). 0 to 23 are a
/// humanoid's joints with the NAO's names and signs. The torso frame has x forward, y left, z up; rotations
/// follow the right-hand rule. Positive pitch turns the moving part forward and down; a bent knee is
/// positive. SimSpark has one hip yaw-pitch per leg and, in type 4, toes. The numbers from 24 on belong to
/// each robot's own joints (OwnJointRange). A robot lacks a joint if RobotModel::linkOfJoint is -1.
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
  numHumanoidJoints,
  maxJoints = 64,
  noJoint = maxJoints
};

/// Where a robot's own joints (waist, wrists, further legs) have their numbers. The range says how a joint is
/// mirrored: which joint takes its angle, and whether the sign stays (pitch) or changes (yaw, roll). In the
/// ranges of pairs the left joints come first, then as many right ones in the same order.
struct OwnJointRange {
  int first, count;
  bool pair, signStays;
  constexpr bool has(int joint) const { return joint >= first && joint < first + count; }
};
constexpr std::array<OwnJointRange, 4> ownJointRanges = {
    {{24, 12, false, true},    // a torso's pitch
     {36, 8, false, false},    // a waist's yaw and roll
     {44, 10, true, true},     // 5 pairs, as a wrist's pitch
     {54, 10, true, false}}};  // 5 pairs, as a wrist's yaw

/// Names of the joints 0 to 23.
constexpr std::array<std::string_view, numHumanoidJoints> humanoidJointNames = {
    "HeadYaw",        "HeadPitch",     "LShoulderPitch", "LShoulderRoll", "LElbowYaw",    "LElbowRoll",
    "RShoulderPitch", "RShoulderRoll", "RElbowYaw",      "RElbowRoll",    "LHipYawPitch", "LHipRoll",
    "LHipPitch",      "LKneePitch",    "LAnklePitch",    "LAnkleRoll",    "LToePitch",    "RHipYawPitch",
    "RHipRoll",       "RHipPitch",     "RKneePitch",     "RAnklePitch",   "RAnkleRoll",   "RToePitch"};

enum class Side { left, right };

/// The leg's first joint; the leg's joints follow in the order of JointId.
constexpr JointId firstLegJoint(Side side) { return side == Side::left ? lHipYawPitch : rHipYawPitch; }

/// One value for each number a joint can have; what the robot lacks stays as it was initialised.
template <typename T>
struct PerJoint : std::array<T, maxJoints> {};

/// [rad, rad/s, ... as the name of the variable says].
using JointArray = PerJoint<double>;
using JointFlags = PerJoint<bool>;

/// The humanoid's joint of that name, or noJoint. A robot's own joints are found by RobotModel::joint.
constexpr JointId humanoidJoint(std::string_view name) {
  for (std::size_t i = 0; i < humanoidJointNames.size(); ++i)
    if (humanoidJointNames[i] == name) return static_cast<JointId>(i);
  return noJoint;
}

}  // namespace plumbline
