#include "walking/estimation/WalkObserver.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {

WalkObserver::WalkObserver(const RobotModel& robot, const VelocityFilterParameters& filter)
    : robot_(robot),
      kinematics_(robot_),
      legs_{LegKinematics(robot_, Side::left), LegKinematics(robot_, Side::right)},
      contacts_(robot_),
      filter_(filter) {}

void WalkObserver::reset() {
  begun_ = false;
  difference_.setZero();
  observed_ = {};
  torsoPlace_.setZero();
  torsoMoved_ = {};
  filter_.reset();
  contacts_.reset();
}

Vec2 WalkObserver::legAngles(Support support) const {
  // A sole that lies flat shows the vertical in the torso frame.
  Vec3 up = Vec3::Zero();
  for (const Side side : {Side::left, Side::right})
    if (support == Support::both || support == supportOf(side)) up += soles_[index(side)].linear().col(2);
  return Vec2(std::atan2(up.y(), up.z()), std::atan2(-up.x(), std::hypot(up.y(), up.z())));
}

void WalkObserver::update(const WalkSensors& sensors, Support support, const WalkAction& action,
                          const WalkModel& model, double average) {
  kinematics_.update(sensors.angles);
  for (const Side side : {Side::left, Side::right}) {
    const int foot = robot_.linkOfJoint[static_cast<std::size_t>(firstLegJoint(side) + 5)];
    soles_[index(side)] = kinematics_.link(foot) * legs_[index(side)].T_foot_sole();
  }
  const Vec2 apart = sensors.torsoAngles - legAngles(support);
  difference_ += (apart - difference_) * (average > 0 ? std::min(1.0, sensors.dt / average) : 0.02);
  angles_ = sensors.torsoAngles - (average > 0 ? difference_ : Vec2(Vec2::Zero()));

  const WalkState before = observed_;
  const Mat3 upright = (rotationY(angles_.y()) * rotationX(angles_.x())).linear();
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 position = upright * (soles_[i].translation() - kinematics_.com());
    const Vec3 ahead = upright * soles_[i].linear().col(0);
    observed_.foot[i] = Pose2(Vec2(position.head<2>()), std::atan2(ahead.y(), ahead.x()));
  }
  observed_.support = support;
  const Vec2 placeBefore = torsoPlace_;
  torsoPlace_ = -(upright * kinematics_.com()).head<2>();
  torsoMoved_ = {};
  if (!begun_) {
    begun_ = true;
    if (sensors.feet) contacts_.update(kinematics_, upright, 0, *sensors.feet, sensors.dt);
    return;
  }
  WalkAction passed = action;
  passed.duration = sensors.dt;
  VelocityEvidence evidence;
  if (sensors.feet) {
    passed.turn = sensors.dt * upright.row(2).dot(sensors.gyro);
    evidence = contacts_.update(kinematics_, upright, passed.turn, *sensors.feet, sensors.dt);
    if (evidence.seen) seen_ = *evidence.seen;
  } else {
    passed.turn = watchFeet(before, support, sensors.dt);
    evidence.seen = seen_;
  }
  WalkState start = before;
  start.support = support;
  observed_.velocity = filter_.update(model, start, passed, sensors.dt, evidence);
  torsoMoved_ = Pose2(placeBefore).inverse() * Pose2(Vec2(sensors.dt * observed_.velocity), passed.turn) *
                Pose2(torsoPlace_);
}

/// The velocity seen in the commanded feet, which are taken to stand still; returns their turn under the
/// torso.
double WalkObserver::watchFeet(const WalkState& before, Support support, double dt) {
  Vec2 moved = Vec2::Zero();
  double turned = 0, feet = 0;
  for (const Side side : {Side::left, Side::right}) {
    if (support != Support::both && support != supportOf(side)) continue;
    const Pose2& now = observed_.foot[index(side)];
    const Pose2& then = before.foot[index(side)];
    const double turn = normalizeAngle(then.heading - now.heading);
    moved += Eigen::Rotation2Dd(-turn) * then.position - now.position;
    turned += turn;
    feet += 1;
  }
  seen_ = moved / (feet * dt);
  return turned / feet;
}

}  // namespace plumbline::walking
