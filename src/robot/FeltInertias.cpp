#include "robot/FeltInertias.h"

namespace plumbline {

std::vector<double> feltInertias(const Mechanism& robot, const std::vector<double>& q) {
  const std::vector<Pose3> poses = linkPoses(robot, q);
  std::vector<double> result;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Mechanism::Joint& joint = robot.joints[j];
    const Pose3& at = poses[j + 1];
    const Vec3 axis = at.linear() * joint.axis;
    double sum = joint.servo.armature;
    std::vector<bool> carried(robot.links.size());
    carried[j + 1] = true;
    for (std::size_t l = j + 1; l < robot.links.size(); ++l) {
      const Mechanism::Link& link = robot.links[l];
      carried[l] = carried[l] || carried[static_cast<std::size_t>(link.parent)];
      if (!carried[l]) continue;
      if (joint.type == Mechanism::Joint::Type::prismatic) {
        sum += link.mass;
        continue;
      }
      const Mat3& R = poses[l].linear();
      const Vec3 arm = poses[l] * link.com - at.translation();
      sum += axis.dot(R * link.inertia * R.transpose() * axis) + link.mass * axis.cross(arm).squaredNorm();
    }
    result.push_back(sum);
  }
  return result;
}

}  // namespace plumbline
