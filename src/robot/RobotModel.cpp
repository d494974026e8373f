#include "robot/RobotModel.h"

#include <algorithm>

#include "robot/NoSuchJoint.h"

namespace plumbline {

int RobotModel::numJoints() const {
  return static_cast<int>(std::ranges::count_if(linkOfJoint, [](int link) { return link >= 0; }));
}

std::vector<JointId> RobotModel::joints() const {
  std::vector<JointId> all;
  for (int j = 0; j < maxJoints; ++j)
    if (const auto joint = static_cast<JointId>(j); has(joint)) all.push_back(joint);
  return all;
}

std::vector<std::string> RobotModel::jointNames() const {
  std::vector<std::string> names;
  for (const JointId joint : joints()) names.emplace_back(jointName(joint));
  return names;
}

std::optional<JointId> RobotModel::joint(std::string_view wanted) const {
  for (int j = 0; j < maxJoints; ++j)
    if (const auto joint = static_cast<JointId>(j); has(joint) && jointName(joint) == wanted) return joint;
  return std::nullopt;
}

JointId RobotModel::requireJoint(std::string_view wanted) const {
  if (const auto found = joint(wanted)) return *found;
  failNoSuchJoint(name, wanted, jointNames());
}

std::string_view RobotModel::jointName(JointId joint) const {
  if (joint < 0) return "?";
  if (joint < numHumanoidJoints) return humanoidJointNames[static_cast<std::size_t>(joint)];
  const auto own = static_cast<std::size_t>(joint - numHumanoidJoints);
  return own < ownJointNames.size() && !ownJointNames[own].empty() ? ownJointNames[own]
                                                                   : std::string_view("?");
}

int RobotModel::linkIndex(std::string_view linkName) const {
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links[i].name == linkName) return static_cast<int>(i);
  return -1;
}

double RobotModel::totalMass() const {
  double sum = 0;
  for (const Link& link : links) sum += link.mass;
  return sum;
}

}  // namespace plumbline
