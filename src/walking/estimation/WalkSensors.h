#pragma once
#include <array>
#include <optional>

#include "math/Types.h"
#include "robot/JointId.h"

namespace plumbline::walking {

/// Where the ground presses on a foot or toe, and how hard.
struct FootContact {
  Vec3 point = Vec3::Zero();  ///< from the link's centre of mass, axes of the link [m]
  Vec3 force = Vec3::Zero();  ///< on the link, in its axes [N]
};

/// The force sensors; a foot or toe that nothing touches has none.
struct FootSensors {
  std::array<std::optional<FootContact>, 2> foot, toe;  ///< left and right
  bool shear = true;  ///< the forces along the sole are measured as well; else only that across it
};

/// The feet's sensors in a robot's message; felt turns each of leftFoot, rightFoot, leftToe and rightToe
/// into an optional FootContact.
template <class Message, class Felt>
FootSensors feltFeet(const Message& message, const Felt& felt) {
  FootSensors feet;
  feet.foot = {felt(message.leftFoot), felt(message.rightFoot)};
  feet.toe = {felt(message.leftToe), felt(message.rightToe)};
  return feet;
}

/// Input of the walk in every cycle.
struct WalkSensors {
  JointArray angles{};              ///< measured [rad]
  Vec2 torsoAngles = Vec2::Zero();  ///< torso against gravity: roll (about x) and pitch (about y) [rad]
  Vec3 gyro = Vec3::Zero();         ///< torso frame [rad/s]
  std::optional<FootSensors> feet;  ///< where the robot feels its feet
  double dt = 0.02;                 ///< of one cycle [s]
};

}  // namespace plumbline::walking
