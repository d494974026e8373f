#include "simulation/league/SoccerWorld.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simulation/effects/EffectTable.h"
#include "simulation/effects/EffectsWorld.h"
#include "simulation/league/FieldObstacles.h"
#include "simulation/league/LeaguePhysics.h"
#include "simulation/league/MakeWorld.h"

namespace plumbline::simulation {

namespace {

/// Hinge i moves link i+1 (LeaguePhysics.h).
int hingeOf(const RobotModel& model, JointId joint) { return model.linkOfJoint[joint] - 1; }

}  // namespace

std::unique_ptr<World> makeWorld(const WorldConfig& config) {
  auto world = std::make_unique<SoccerWorld>(config);
  if (config.effects.empty()) return world;
  return std::make_unique<EffectsWorld>(std::move(world), config);
}

SoccerWorld::SoccerWorld(const WorldConfig& config) : config_(config) {
  checkEffects(config_.effects);
  reset();
}

void SoccerWorld::reset() {
  // Only a new engine has no trace of the past; making it takes a tenth of a millisecond.
  robots_.clear();
  touchedBall_.clear();
  touchedRobots_.clear();
  const PhysicsConfig settings = leaguePhysics(config_);
  gravityForce_ = settings.gravity;
  physics_ = makePhysics(config_.engine, settings);
  physics_->addGround(material::ground);
  for (const FieldObstacle& obstacle : fieldObstacles(config_.field))
    physics_->addStatic(obstacle.shape, obstacle.T_world_shape, material::obstacle);
  ballHandle_ = physics_->addAssembly(leagueBall(config_.field), translation(0, 0, config_.field.ballRadius));
}

RobotHandle SoccerWorld::addRobot(const RobotModel& model, const Pose3& T_world_torso) {
  const RobotHandle handle =
      physics_->addAssembly(leagueRobot(model, config_), T_world_torso * translation(model.links.at(0).com));
  Robot& robot = robots_[handle];
  robot.model = model;
  using Sensor = std::optional<FootForce> RobotReadings::*;
  const std::pair<const char*, Sensor> sensors[] = {{"lFoot", &RobotReadings::leftFoot},
                                                    {"rFoot", &RobotReadings::rightFoot},
                                                    {"lToe", &RobotReadings::leftToe},
                                                    {"rToe", &RobotReadings::rightToe}};
  for (const auto& [name, sensor] : sensors)
    if (const int link = model.linkIndex(name); link >= 0) robot.feet.emplace_back(link, sensor);
  return handle;
}

void SoccerWorld::removeRobot(RobotHandle robot) {
  get(robot);
  physics_->removeAssembly(robot);
  robots_.erase(robot);
  std::erase(touchedBall_, robot);
  std::erase_if(touchedRobots_, [robot](const RobotContact& c) { return c.a == robot || c.b == robot; });
}

void SoccerWorld::moveRobot(RobotHandle robot, const Pose3& T_world_torso) {
  physics_->moveRigidly(robot, T_world_torso * translation(get(robot).model.links[0].com));
}

void SoccerWorld::setPosture(RobotHandle handle, const JointArray& angles) {
  stopMotors(handle);
  setState(handle, {torso(handle).pose, Vec3::Zero(), Vec3::Zero()}, angles, JointArray{});
}

void SoccerWorld::stopMotors(RobotHandle handle) {
  for (std::size_t hinge = 0; hinge + 1 < get(handle).model.links.size(); ++hinge)
    physics_->setMotor(handle, static_cast<int>(hinge), 0);
}

void SoccerWorld::setState(RobotHandle handle, const BodyState& torso, const JointArray& angles,
                           const JointArray& rates) {
  Robot& robot = get(handle);
  const AssemblyState state = toAssemblyState(robot, torso, angles, rates);
  physics_->setState(handle, state);
  robot.lastVelocity = state.root.linearVelocity;
  senseAngles(handle, robot);
}

void SoccerWorld::setVelocities(RobotHandle handle, const BodyState& torso, const JointArray& rates) {
  Robot& robot = get(handle);
  const AssemblyState state = toAssemblyState(robot, torso, JointArray{}, rates);
  physics_->setVelocities(handle, state);
  robot.lastVelocity = state.root.linearVelocity;
}

AssemblyState SoccerWorld::toAssemblyState(const Robot& robot, const BodyState& torso,
                                           const JointArray& angles, const JointArray& rates) {
  AssemblyState state;
  const Vec3 toCom = torso.pose.linear() * robot.model.links[0].com;
  state.root = torso;
  state.root.pose.translation() += toCom;
  state.root.linearVelocity += torso.angularVelocity.cross(toCom);
  state.angle.assign(robot.model.links.size() - 1, 0);
  state.rate = state.angle;
  for (std::size_t j = 0; j < maxJoints; ++j)
    if (const int hinge = hingeOf(robot.model, static_cast<JointId>(j)); hinge >= 0) {
      state.angle[static_cast<std::size_t>(hinge)] = angles[j];
      state.rate[static_cast<std::size_t>(hinge)] = rates[j];
    }
  return state;
}

void SoccerWorld::setJointVelocity(RobotHandle handle, JointId joint, double velocity) {
  const Robot& robot = get(handle);
  if (joint < 0 || joint >= maxJoints || !robot.model.has(joint))
    throw std::invalid_argument("simulation: robot " + robot.model.name + " has no joint " +
                                std::string(robot.model.jointName(joint)));
  if (!std::isfinite(velocity))
    throw std::invalid_argument("simulation: velocity of " + std::string(robot.model.jointName(joint)) +
                                " is not finite");
  const Link& link = robot.model.linkMovedBy(joint);
  const int hinge = hingeOf(robot.model, joint);
  // At or beyond a stop the league's server leaves the motor as it is, whichever way the command goes.
  const double angle = physics_->hingeAngle(handle, hinge);
  if (angle > link.lower && angle < link.upper)
    physics_->setMotor(handle, hinge, std::clamp(velocity, -link.maxSpeed, link.maxSpeed));
  if (velocity != 0) physics_->wake(handle, robot.model.linkOfJoint[joint]);
}

void SoccerWorld::step() {
  for (auto& [handle, robot] : robots_) senseAcceleration(handle, robot);
  physics_->step();
  if (!config_.lastingCommands)
    for (const auto& [handle, robot] : robots_) stopMotors(handle);
  touchedBall_.clear();
  for (auto& [handle, robot] : robots_) {
    senseAngles(handle, robot);
    senseFeet(handle, robot);
    const BodyState body = physics_->bodyState(handle, 0);
    robot.readings.gyro = body.pose.linear().transpose() * body.angularVelocity;
  }
  for (const Contact& contact : physics_->contacts())
    if (contact.assemblyA == ballHandle_ && contact.assemblyB >= 0 &&
        std::find(touchedBall_.begin(), touchedBall_.end(), contact.assemblyB) == touchedBall_.end())
      touchedBall_.push_back(contact.assemblyB);
  touchedRobots_.clear();
  for (const Contact& contact : physics_->contacts())
    if (contact.assemblyA >= 0 && contact.assemblyB >= 0 && contact.assemblyA != contact.assemblyB &&
        contact.assemblyA != ballHandle_ && contact.assemblyB != ballHandle_)
      touchedRobots_.push_back({contact.assemblyA, contact.assemblyB, contact.point});
}

/// From the velocities before the step, so the reading is one cycle late.
void SoccerWorld::senseAcceleration(RobotHandle handle, Robot& robot) const {
  const BodyState body = physics_->bodyState(handle, 0);
  const Vec3 acceleration = (body.linearVelocity - robot.lastVelocity) / config_.stepSeconds;
  robot.lastVelocity = body.linearVelocity;
  robot.readings.acc = body.pose.linear().transpose() * (acceleration - gravityForce_);
}

void SoccerWorld::senseAngles(RobotHandle handle, Robot& robot) const {
  for (int j = 0; j < maxJoints; ++j) {
    const int hinge = hingeOf(robot.model, static_cast<JointId>(j));
    if (hinge >= 0) robot.readings.angle[static_cast<std::size_t>(j)] = physics_->hingeAngle(handle, hinge);
  }
}

void SoccerWorld::senseFeet(RobotHandle handle, Robot& robot) const {
  for (const auto& [link, sensor] : robot.feet) {
    Vec3 force = Vec3::Zero(), weighted = Vec3::Zero();
    double weight = 0;
    bool touched = false;
    for (const Contact& contact : physics_->contacts()) {
      // The server's sensor notices a contact only through the first of the two colliders, which is the
      // ball.
      const bool isA = contact.assemblyA == handle && contact.bodyA == link;
      const bool isB =
          contact.assemblyB == handle && contact.bodyB == link && contact.assemblyA != ballHandle_;
      if (!isA && !isB) continue;
      touched = true;
      force += isA ? contact.forceOnA : Vec3(-contact.forceOnA);
      weighted += contact.forceOnA.norm() * contact.point;
      weight += contact.forceOnA.norm();
    }
    std::optional<FootForce>& reading = robot.readings.*sensor;
    if (!touched) {
      reading.reset();
    } else if (weight > 0) {
      const Pose3 T_foot_world = physics_->bodyState(handle, link).pose.inverse();
      reading = FootForce{T_foot_world * Vec3(weighted / weight), T_foot_world.linear() * force};
    } else if (!reading) {
      reading.emplace();  // asleep since before it touched; otherwise a sleeper keeps its last reading
    }
  }
}

BodyState SoccerWorld::torso(RobotHandle robot) const {
  const Vec3& com = get(robot).model.links[0].com;
  BodyState state = physics_->bodyState(robot, 0);
  const Vec3 toOrigin = state.pose.linear() * -com;
  state.pose.translation() += toOrigin;
  state.linearVelocity += state.angularVelocity.cross(toOrigin);
  return state;
}

void SoccerWorld::setBall(const Vec3& position, const Vec3& velocity) {
  setBall({translation(position), velocity, Vec3::Zero()});
}

void SoccerWorld::setBall(const BodyState& state) { physics_->setState(ballHandle_, {state, {}, {}}); }

SoccerWorld::Robot& SoccerWorld::get(RobotHandle robot) {
  return const_cast<Robot&>(static_cast<const SoccerWorld*>(this)->get(robot));
}

const SoccerWorld::Robot& SoccerWorld::get(RobotHandle robot) const {
  const auto it = robots_.find(robot);
  if (it == robots_.end())
    throw std::out_of_range("simulation: no robot " + std::to_string(robot) + " in this world");
  return it->second;
}

}  // namespace plumbline::simulation
