#include "robot/Mechanism.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "robot/NoSuchJoint.h"

namespace plumbline {
namespace {

template <typename T>
int indexOf(const std::vector<T>& things, std::string_view name) {
  const auto it = std::find_if(things.begin(), things.end(), [&](const T& t) { return t.name == name; });
  return it == things.end() ? -1 : static_cast<int>(it - things.begin());
}

}  // namespace

Mat3 rotationOfRpy(const Vec3& rpy) {
  return (Eigen::AngleAxisd(rpy.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Vec3::UnitX()))
      .toRotationMatrix();
}

Vec3 rpyOfRotation(const Mat3& r) {
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  if (std::hypot(r(0, 0), r(1, 0)) > 1e-9)
    return {std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0))};
  return {std::atan2(-r(1, 2), r(1, 1)), pitch, 0};  // pitch +-pi/2: roll and yaw turn about one axis
}

Pose3 Mechanism::Joint::T_parent_joint() const {
  Pose3 pose = translation(origin);
  if (!rpy.isZero(0)) pose.linear() = rotationOfRpy(rpy);
  return pose;
}

Pose3 Mechanism::Joint::T_parent_child(double q) const {
  return T_parent_joint() * (type == Type::revolute ? rotation(axis, q) : translation(axis * q));
}

int Mechanism::jointIndex(std::string_view joint) const { return indexOf(joints, joint); }

int Mechanism::requireJoint(std::string_view joint) const {
  const int index = jointIndex(joint);
  if (index < 0) failNoSuchJoint(name, joint, jointNames());
  return index;
}

std::vector<std::string> Mechanism::jointNames() const {
  std::vector<std::string> names;
  for (const Joint& joint : joints) names.push_back(joint.name);
  return names;
}

int Mechanism::linkIndex(std::string_view link) const {
  if (const int index = indexOf(links, link); index >= 0) return index;
  const int frame = indexOf(frames, link);
  return frame < 0 ? -1 : frames[static_cast<std::size_t>(frame)].link;
}

int Mechanism::footIndex(std::string_view foot) const { return indexOf(feet, foot); }

double Mechanism::totalMass() const {
  double sum = 0;
  for (const Link& link : links) sum += link.mass;
  return sum;
}

bool Mechanism::sharesServo() const {
  const Servo* first = nullptr;
  int motors = 0;
  for (const Joint& joint : joints) {
    if (joint.driver >= 0) continue;
    if (!first) first = &joint.servo;
    if (joint.servo != *first) return false;
    ++motors;
  }
  return motors > 1;
}

int Mechanism::onlyMotor() const {
  int only = -1;
  for (int j = 0; j < numJoints(); ++j) {
    if (motorOf(j) != j) continue;
    if (only >= 0) return -1;
    only = j;
  }
  return only;
}

std::vector<int> Mechanism::chain(int link) const {
  std::vector<int> result;
  for (int l = link; l > 0; l = links[static_cast<std::size_t>(l)].parent) result.push_back(l - 1);
  std::reverse(result.begin(), result.end());
  return result;
}

std::vector<Pose3> linkPoses(const Mechanism& mechanism, const std::vector<double>& q) {
  if (q.size() != mechanism.joints.size())
    throw std::invalid_argument("linkPoses: " + std::to_string(q.size()) + " positions for " +
                                std::to_string(mechanism.joints.size()) + " joints");
  std::vector<Pose3> poses{Pose3::Identity()};
  poses.reserve(mechanism.links.size());
  for (std::size_t j = 0; j < q.size(); ++j) {
    const Mechanism::Joint& joint = mechanism.joints[j];
    poses.push_back(poses[static_cast<std::size_t>(joint.parent)] * joint.T_parent_child(q[j]));
  }
  return poses;
}

Vec3 centreOfMass(const Mechanism& mechanism, const std::vector<Pose3>& T_base_link) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < mechanism.links.size(); ++i)
    sum += mechanism.links[i].mass * (T_base_link[i] * mechanism.links[i].com);
  return sum / mechanism.totalMass();
}

}  // namespace plumbline
