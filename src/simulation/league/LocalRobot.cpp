#include "simulation/league/LocalRobot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/league/MakeWorld.h"
#include "simulation/referee/rules/SelfCollision.h"

namespace plumbline::simulation {

namespace {

const SelfCollision::Parameters league;  ///< as the league has the rule

/// How far a shape reaches below its centre when its frame is turned so [m].
double reachBelow(const Shape& shape, const Mat3& rotation) {
  const Vec3 down = rotation.row(2).cwiseAbs();
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return shape.size.x();
    case Shape::Kind::capsule:
      return shape.size.x() + down.z() * shape.size.z() / 2;
    case Shape::Kind::box:
      break;
  }
  return down.dot(shape.size) / 2;
}

}  // namespace

LocalRobot::LocalRobot(const RobotModel& model, const WorldConfig& config)
    : model_(model), config_(config), world_(makeWorld(config)) {
  restart();
}

void LocalRobot::act(const JointArray& velocities) {
  if (!config_.actionDelay) pending_ = velocities;
  for (int j = 0; j < maxJoints; ++j)
    if (const auto joint = static_cast<JointId>(j); model_.has(joint))
      world_->setJointVelocity(handle_, joint, limbs_.joints()[joint] ? 0 : pending_[joint]);
  world_->step();
  pending_ = velocities;
  ++cycles_;
  for (const LimbCollision& collision : limbCollisions(*world_, handle_, model_, league.tolerance))
    for (const Limb& limb : {collision.a, collision.b}) limbs_.freeze(limb, time(), league.times());
  limbs_.thaw(time(), league.times());
}

bool LocalRobot::overlaps() const {
  return !limbCollisions(*world_, handle_, model_, league.tolerance).empty();
}

void LocalRobot::restart(const Pose2& place, const JointArray& angles) {
  const Pose3 flat = translation(place.x(), place.y(), 0) * rotationZ(place.heading);
  restart(flat, angles);
  restart(translation(0, 0, -lowestPoint()) * flat, angles);
}

void LocalRobot::restart(const Pose3& T_world_torso, const JointArray& angles) {
  world_->reset();
  handle_ = world_->addRobot(model_, T_world_torso);
  world_->setPosture(handle_, angles);
  pending_.fill(0);
  limbs_ = {};
  cycles_ = 0;
}

double LocalRobot::lowestPoint() const {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model_.links.size(); ++i) {
    const Link& link = model_.links[i];
    if (!link.collides) continue;
    const Pose3 pose = world_->linkState(handle_, static_cast<int>(i)).pose * translation(-link.com) *
                       link.shape.T_link_shape;
    lowest = std::min(lowest, pose.translation().z() - reachBelow(link.shape, pose.linear()));
  }
  return lowest;
}

}  // namespace plumbline::simulation
