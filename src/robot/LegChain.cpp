#include "robot/LegChain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/Index.h"

namespace plumbline {

LegChain::LegChain(const RobotModel& model, Side side) {
  const int first = firstLegJoint(side);
  std::array<bool, 6> found{};
  std::size_t next = joints_.size();
  // From the foot up; offsets on the way to the next joint of the leg are added to its origin.
  const JointId ankleRoll = static_cast<JointId>(first + 5);
  for (int i = model.has(ankleRoll) ? model.linkOfJoint[ankleRoll] : 0; i > 0;
       i = model.links[at(i)].parent) {
    const Link& link = model.links[at(i)];
    const int angle = link.joint - first;
    if (angle >= 0 && angle < 6 && model.has(link.joint)) {
      Joint& joint = joints_[--next];
      joint = {at(angle), link.origin, link.axis, link.lower, link.upper};
      found[at(angle)] = true;
    } else if (next < joints_.size()) {
      joints_[next].origin += link.origin;
    }
  }
  if (std::ranges::find(found, false) == found.end()) return;
  int missing = 0;
  while (missing < 6 && model.has(static_cast<JointId>(first + missing))) ++missing;
  if (missing == 6) missing = static_cast<int>(std::ranges::find(found, false) - found.begin());
  const auto joint = static_cast<JointId>(first + missing);
  throw std::invalid_argument("robot " + model.name + ": the leg has no " +
                              std::string(model.jointName(joint)) +
                              " between torso and foot; leg kinematics needs the six joints from " +
                              std::string(model.jointName(static_cast<JointId>(first))) + " to " +
                              std::string(model.jointName(ankleRoll)));
}

std::array<Pose3, 6> LegChain::poses(const LegAngles& angles) const {
  std::array<Pose3, 6> poses;
  Pose3 pose = Pose3::Identity();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    pose = pose * translation(joint.origin) * rotation(joint.axis, angles[joint.angle]);
    poses[i] = pose;
  }
  return poses;
}

void LegChain::clip(LegAngles& angles, bool& moved) const {
  constexpr double rounding = 1e-9;  // [rad]
  for (const Joint& joint : joints_) {
    double& q = angles[joint.angle];
    const double clipped = std::clamp(q, joint.lower, joint.upper);
    moved = moved || std::abs(clipped - q) > rounding;
    q = clipped;
  }
}

}  // namespace plumbline
