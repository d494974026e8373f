#pragma once
#include <array>
#include <string>
#include <vector>

#include "math/Types.h"
#include "robot/JointId.h"
#include "robot/Shape.h"

namespace plumbline {

/// One rigid link and the hinge that joins it to its parent. The link's frame sits on its joint and has the
/// parent's orientation when the joint is at zero (as in URDF with zero rpy).
struct Link {
  std::string name;             ///< field term: "torso", "lThigh", ...
  int parent = -1;              ///< index into RobotModel::links, smaller than the link's own; -1: the root
  JointId joint = numJoints;    ///< the hinge to the parent; numJoints for the root
  Vec3 origin = Vec3::Zero();   ///< joint position in the parent's frame [m]
  Vec3 axis = Vec3::UnitZ();    ///< joint axis, unit, in parent and child frame alike
  double lower = 0, upper = 0;  ///< joint limits [rad]
  double maxSpeed = 0;          ///< [rad/s]
  double mass = 0;              ///< [kg]
  Vec3 com = Vec3::Zero();      ///< centre of mass in the link's frame [m]
  Mat3 inertia = Mat3::Zero();  ///< about com, axes of the link's frame [kg m^2]
  Shape shape;                  ///< body as drawn
  bool collides = false;        ///< whether shape takes part in collisions
};

/// A robot as data: a tree of links, parents before children, link 0 the torso.
struct RobotModel {
  std::string name;
  std::vector<Link> links;
  std::array<int, numJoints> linkOfJoint{};  ///< link moved by a joint, -1 if the robot lacks it
  bool sharedHipYawPitch = false;  ///< one motor turns both hips' yaw pitch by the same angle, as in the NAO

  bool has(JointId joint) const { return linkOfJoint[joint] >= 0; }
  const Link& linkMovedBy(JointId joint) const { return links[static_cast<std::size_t>(linkOfJoint[joint])]; }
  /// Index of the link of that name, or -1.
  int linkIndex(std::string_view linkName) const;
  double totalMass() const;
};

}  // namespace plumbline
