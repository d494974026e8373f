#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "simspark/TeamSide.h"

namespace plumbline::simulation {

// The parts of the monitor's scene that do not move, to the character as the league's viewers know them.

/// Field, lights, goals, walls and the invisible marks in a full scene.
const std::string& fieldScene();
/// The same nodes in a difference, in which they never change.
const std::string& fieldDifference();

/// What hangs below the transform of one of a robot's bodies.
struct BodyLook {
  std::string link{};       ///< name of the link of the RobotModel
  std::string mesh{};       ///< file of a mesh, or empty: a simple shape
  std::string shape{};      ///< "StdUnitSphere", "StdCapsule 0.015 0.08"
  std::string scale{};      ///< "0.08 0.08 0.08"
  std::string material{};   ///< of a shape
  std::string materials{};  ///< of a mesh, sorted; "num", "team", "type" depend on the robot
  bool turned = false;      ///< the mesh hangs in a transform of its own
  bool marker = false;      ///< the marker of a selected player follows
};

/// The bodies of a robot of a type in the scene's order.
std::vector<BodyLook> robotLooks(int type);

/// "matNum3 matLeft matType0 naowhite" of "num team type naowhite"; without a team as the meshes are.
std::string materialNames(std::string_view materials, int type, int unum, simspark::TeamSide side);

}  // namespace plumbline::simulation
