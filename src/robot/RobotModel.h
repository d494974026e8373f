#pragma once
#include <optional>
#include <string>
#include <string_view>
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
  JointId joint = noJoint;      ///< the hinge to the parent; noJoint for the root
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
  PerJoint<int> linkOfJoint = [] {  ///< link moved by a joint, -1 if the robot lacks it
    PerJoint<int> none;
    none.fill(-1);
    return none;
  }();
  bool sharedHipYawPitch = false;  ///< one motor turns both hips' yaw pitch by the same angle, as in the NAO
  std::vector<std::string> ownJointNames;  ///< of the joints from numHumanoidJoints on; "" or none: no joint

  bool has(JointId joint) const { return linkOfJoint[joint] >= 0; }
  /// Its link holds the joint's limits and speed.
  const Link& linkMovedBy(JointId joint) const { return links[static_cast<std::size_t>(linkOfJoint[joint])]; }

  int numJoints() const;
  /// All joints the robot has, its own included, by their numbers, and their names in the same order.
  std::vector<JointId> joints() const;
  std::vector<std::string> jointNames() const;
  /// The joint of that name; nothing if this robot has none.
  std::optional<JointId> joint(std::string_view jointName) const;
  /// The same; throws std::invalid_argument that names the robot and the nearest name it has.
  JointId requireJoint(std::string_view jointName) const;
  /// Name of a joint, also of a humanoid's that this robot lacks; "?" for a number without a name. Valid as
  /// long as the model.
  std::string_view jointName(JointId joint) const;

  /// Index of the link of that name, or -1.
  int linkIndex(std::string_view linkName) const;
  double totalMass() const;
};

}  // namespace plumbline
