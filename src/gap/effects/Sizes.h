#pragma once
#include <algorithm>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

// The ranges of effects are for a robot of a NAO's size. These are factors for other robots; they are 1 for a
// NAO and smaller robots unless stated otherwise. If a start is still far too strong for a joint, the search
// weakens it.

namespace sizes {

constexpr double mass = 5.5;        // [kg] of a NAO
constexpr double reach = 0.14;      // [m] from joint to joint, a little more than a NAO's longest
constexpr double torque = 3.5;      // [N m] of its strongest motor
constexpr double weakTorque = 0.3;  // [N m], less than its weakest
constexpr double armature = 0.006;  // [kg m^2]
constexpr double gain = 5;          // [N m/rad] of its weakest servo

}  // namespace sizes

/// A place's joint; the first of a group, or of all of them.
inline const Mechanism::Joint& jointOf(const Mechanism& m, const Place& p) {
  if (p.site == Site::everywhere && p.index >= 0)
    return m.joints[static_cast<std::size_t>(m.groups[static_cast<std::size_t>(p.index)].joints[0])];
  return m.joints[p.site == Site::joint ? static_cast<std::size_t>(p.index) : 0];
}

/// By the robot's mass.
inline double scaleOfMass(const Mechanism& m, const Place&) {
  return std::max(1.0, m.totalMass() / sizes::mass);
}

/// By the longest distance from one joint to the next.
inline double scaleOfLength(const Mechanism& m, const Place&) {
  double longest = 0;
  for (const auto& joint : m.joints)
    if (joint.parent > 0 && joint.type == Mechanism::Joint::Type::revolute)
      longest = std::max(longest, joint.origin.norm());
  return std::max(1.0, longest / sizes::reach);
}

/// By the rotor's inertia, or the motor's strength if the model's rotor is light.
inline double scaleOfRotor(const Mechanism& m, const Place& p) {
  const auto& joint = jointOf(m, p);
  return std::max({1.0, joint.servo.armature / sizes::armature, joint.maxTorque / sizes::torque});
}

/// By the angle that a torque causes at a soft servo.
inline double scaleOfCompliance(const Mechanism& m, const Place& p) {
  return std::max(1.0, sizes::gain / std::max(1e-3, jointOf(m, p).servo.kp));
}

/// By heat, which grows with the square of the torque: less than 1 for a strong motor.
inline double scalePerHeat(const Mechanism& m, const Place& p) {
  const double most = std::max(1e-3, jointOf(m, p).maxTorque);
  const double like = std::clamp(most, sizes::weakTorque, sizes::torque);
  return like * like / (most * most);
}

}  // namespace plumbline::gap
