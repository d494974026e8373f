#include "walking/estimation/WalkObserver.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {

WalkObserver::WalkObserver(const RobotModel& robot_, const VelocityFilterParameters& filter_)
    : robot(robot_),
      kinematics(robot),
      legs{LegKinematics(robot, Side::left), LegKinematics(robot, Side::right)},
      contacts(robot),
      filter(filter_) {}

void WalkObserver::reset() {
  begun = false;
  difference.setZero();
  observed = {};
  torsoPlace.setZero();
  torsoMoved = {};
  filter.reset();
  contacts.reset();
}

Vec2 WalkObserver::legAngles(Support support) const {
  // A sole that lies flat shows the vertical in the torso frame.
  Vec3 up = Vec3::Zero();
  for (const Side side : {Side::left, Side::right})
    if (support == Support::both || support == supportOf(side)) up += soles[index(side)].linear().col(2);
  return Vec2(std::atan2(up.y(), up.z()), std::atan2(-up.x(), std::hypot(up.y(), up.z())));
}

void WalkObserver::update(const WalkSensors& sensors, Support support, const WalkAction& action,
                          const WalkModel& model, double average) {
  kinematics.update(sensors.angles);
  for (const Side side : {Side::left, Side::right}) {
    const int foot = robot.linkOfJoint[static_cast<std::size_t>(firstLegJoint(side) + 5)];
    soles[index(side)] = kinematics.link(foot) * legs[index(side)].T_foot_sole();
  }
  const Vec2 apart = sensors.torsoAngles - legAngles(support);
  difference += (apart - difference) * (average > 0 ? std::min(1.0, sensors.dt / average) : 0.02);
  angles = sensors.torsoAngles - (average > 0 ? difference : Vec2(Vec2::Zero()));

  const WalkState before = observed;
  const Mat3 upright = (rotationY(angles.y()) * rotationX(angles.x())).linear();
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 position = upright * (soles[i].translation() - kinematics.com());
    const Vec3 ahead = upright * soles[i].linear().col(0);
    observed.foot[i] = Pose2(Vec2(position.head<2>()), std::atan2(ahead.y(), ahead.x()));
  }
  observed.support = support;
  const Vec2 placeBefore = torsoPlace;
  torsoPlace = -(upright * kinematics.com()).head<2>();
  torsoMoved = {};
  if (!begun) {
    begun = true;
    if (sensors.feet) contacts.update(kinematics, upright, 0, *sensors.feet, sensors.dt);
    return;
  }
  WalkAction passed = action;
  passed.duration = sensors.dt;
  VelocityEvidence evidence;
  if (sensors.feet) {
    passed.turn = sensors.dt * upright.row(2).dot(sensors.gyro);
    evidence = contacts.update(kinematics, upright, passed.turn, *sensors.feet, sensors.dt);
    if (evidence.seen) seen = *evidence.seen;
  } else {
    passed.turn = watchFeet(before, support, sensors.dt);
    evidence.seen = seen;
  }
  WalkState start = before;
  start.support = support;
  observed.velocity = filter.update(model, start, passed, sensors.dt, evidence);
  torsoMoved = Pose2(placeBefore).inverse() * Pose2(Vec2(sensors.dt * observed.velocity), passed.turn) *
               Pose2(torsoPlace);
}

/// The velocity seen in the commanded feet, which are taken to stand still; returns their turn under the
/// torso.
double WalkObserver::watchFeet(const WalkState& before, Support support, double dt) {
  Vec2 moved = Vec2::Zero();
  double turned = 0, feet = 0;
  for (const Side side : {Side::left, Side::right}) {
    if (support != Support::both && support != supportOf(side)) continue;
    const Pose2& now = observed.foot[index(side)];
    const Pose2& then = before.foot[index(side)];
    const double turn = normalizeAngle(then.heading - now.heading);
    moved += Eigen::Rotation2Dd(-turn) * then.position - now.position;
    turned += turn;
    feet += 1;
  }
  seen = moved / (feet * dt);
  return turned / feet;
}

}  // namespace plumbline::walking
