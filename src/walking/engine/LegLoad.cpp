#include "walking/engine/LegLoad.h"

#include "math/Gravity.h"
#include "walking/model/WalkState.h"

namespace plumbline::walking {

LegLoad::LegLoad(const RobotModel& robot)
    : robot_(robot),
      kinematics_(robot_),
      legs_{LegKinematics(robot_, Side::left), LegKinematics(robot_, Side::right)},
      mass_(robot_.totalMass()) {}

const JointArray& LegLoad::update(const JointArray& angles, const Vec2& torsoAngles,
                                  const std::array<double, 2>& share, const Vec2& pressure) {
  kinematics_.update(angles);
  // The vertical in the torso's frame.
  const Vec3 up = (rotationY(torsoAngles.y()) * rotationX(torsoAngles.x())).linear().transpose().col(2);
  // Force and moment about the torso's origin that act from outside on a link and all that hangs on it.
  std::array<Vec3, ForwardKinematics::maxLinks> force, moment;
  const std::size_t count = robot_.links.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 place = kinematics_.link(static_cast<int>(i)) * robot_.links[i].com;
    force[i] = -robot_.links[i].mass * earthGravity * up;
    moment[i] = place.cross(force[i]);
  }
  for (const Side side : {Side::left, Side::right}) {
    const auto foot =
        static_cast<std::size_t>(robot_.linkOfJoint[static_cast<std::size_t>(firstLegJoint(side) + 5)]);
    const Vec3 point =
        kinematics_.link(static_cast<int>(foot)) *
        (legs_[index(side)].T_foot_sole() * Vec3(pressure.x(), outward(side) * pressure.y(), 0));
    const Vec3 toMass = kinematics_.com() - point;
    const double height = toMass.dot(up);
    if (!(height > 0.05)) continue;
    const Vec3 push = share[index(side)] * mass_ * earthGravity / height * toMass;
    force[foot] += push;
    moment[foot] += point.cross(push);
  }
  torque_.fill(0);
  for (std::size_t i = count; i-- > 1;) {
    const Link& link = robot_.links[i];
    const Pose3& T = kinematics_.link(static_cast<int>(i));
    const Vec3 about = moment[i] - T.translation().cross(force[i]);
    if (link.joint != noJoint)
      torque_[static_cast<std::size_t>(link.joint)] = -(T.linear() * link.axis).dot(about);
    force[static_cast<std::size_t>(link.parent)] += force[i];
    moment[static_cast<std::size_t>(link.parent)] += moment[i];
  }
  return torque_;
}

}  // namespace plumbline::walking
