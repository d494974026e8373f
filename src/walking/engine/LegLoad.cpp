#include "walking/engine/LegLoad.h"

#include "walking/model/WalkState.h"

namespace plumbline::walking {

LegLoad::LegLoad(const RobotModel& robot_)
    : robot(robot_),
      kinematics(robot),
      legs{LegKinematics(robot, Side::left), LegKinematics(robot, Side::right)},
      mass(robot.totalMass()) {}

const JointArray& LegLoad::update(const JointArray& angles, const Vec2& torsoAngles,
                                  const std::array<double, 2>& share, const Vec2& pressure) {
  constexpr double gravity = 9.81;
  kinematics.update(angles);
  // The vertical in the torso's frame.
  const Vec3 up = (rotationY(torsoAngles.y()) * rotationX(torsoAngles.x())).linear().transpose().col(2);
  // Force and moment about the torso's origin that act from outside on a link and all that hangs on it.
  std::array<Vec3, ForwardKinematics::maxLinks> force, moment;
  const std::size_t count = robot.links.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 place = kinematics.link(static_cast<int>(i)) * robot.links[i].com;
    force[i] = -robot.links[i].mass * gravity * up;
    moment[i] = place.cross(force[i]);
  }
  for (const Side side : {Side::left, Side::right}) {
    const auto foot =
        static_cast<std::size_t>(robot.linkOfJoint[static_cast<std::size_t>(firstLegJoint(side) + 5)]);
    const Vec3 point =
        kinematics.link(static_cast<int>(foot)) *
        (legs[index(side)].T_foot_sole() * Vec3(pressure.x(), outward(side) * pressure.y(), 0));
    const Vec3 toMass = kinematics.com() - point;
    const double height = toMass.dot(up);
    if (!(height > 0.05)) continue;
    const Vec3 push = share[index(side)] * mass * gravity / height * toMass;
    force[foot] += push;
    moment[foot] += point.cross(push);
  }
  torque.fill(0);
  for (std::size_t i = count; i-- > 1;) {
    const Link& link = robot.links[i];
    const Pose3& T = kinematics.link(static_cast<int>(i));
    const Vec3 about = moment[i] - T.translation().cross(force[i]);
    if (link.joint != noJoint)
      torque[static_cast<std::size_t>(link.joint)] = -(T.linear() * link.axis).dot(about);
    force[static_cast<std::size_t>(link.parent)] += force[i];
    moment[static_cast<std::size_t>(link.parent)] += moment[i];
  }
  return torque;
}

}  // namespace plumbline::walking
