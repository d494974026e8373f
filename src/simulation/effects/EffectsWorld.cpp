#include "simulation/effects/EffectsWorld.h"

#include <cmath>

#include "simulation/effects/BodyEffects.h"
#include "simulation/effects/EffectTable.h"

namespace plumbline::simulation {

EffectsWorld::EffectsWorld(std::unique_ptr<World> world, const WorldConfig& config)
    : world_(std::move(world)), config_(config) {
  checkEffects(config_.effects);
}

void EffectsWorld::read(RobotHandle handle, bool newCycle) {
  Robot& robot = get(handle);
  JointArray slack{};
  for (int j = 0; j < maxJoints; ++j)
    slack[static_cast<std::size_t>(j)] = robot.motors.slack(static_cast<JointId>(j));
  robot.readings = robot.sensors.read(world_->readings(handle), slack, newCycle);
}

RobotHandle EffectsWorld::addRobot(const RobotModel& model, const Pose3& T_world_torso) {
  const RobotHandle handle = world_->addRobot(withEffects(model, config_.effects), T_world_torso);
  robots_.insert_or_assign(
      handle, Robot{model,
                    MotorEffects(config_.effects, config_.stepSeconds, static_cast<std::uint64_t>(handle)),
                    SensorEffects(config_.effects, config_.stepSeconds, static_cast<std::uint64_t>(handle)),
                    {}});
  read(handle, false);
  return handle;
}

void EffectsWorld::removeRobot(RobotHandle robot) {
  world_->removeRobot(robot);
  robots_.erase(robot);
}

void EffectsWorld::moveRobot(RobotHandle robot, const Pose3& T_world_torso) {
  world_->moveRobot(robot, T_world_torso);
  read(robot, false);
}

void EffectsWorld::setPosture(RobotHandle robot, const JointArray& angles) {
  world_->setPosture(robot, angles);
  get(robot).motors.restart();
  get(robot).sensors.restart();
  read(robot, false);
}

void EffectsWorld::setState(RobotHandle robot, const BodyState& torso, const JointArray& angles,
                            const JointArray& rates) {
  world_->setState(robot, torso, angles, rates);
  read(robot, false);
}

void EffectsWorld::setVelocities(RobotHandle robot, const BodyState& torso, const JointArray& rates) {
  world_->setVelocities(robot, torso, rates);
  read(robot, false);
}

void EffectsWorld::setJointVelocity(RobotHandle handle, JointId joint, double velocity) {
  if (joint >= 0 && joint < maxJoints && get(handle).motors.touches(joint)) {
    Robot& robot = get(handle);
    // The world refuses impossible effects at once.
    if (!robot.model.has(joint) || !std::isfinite(velocity))
      world_->setJointVelocity(handle, joint, velocity);
    robot.motors.command(joint, velocity);
    return;
  }
  world_->setJointVelocity(handle, joint, velocity);
}

void EffectsWorld::step() {
  for (auto& [handle, robot] : robots_) {
    robot.motors.beginCycle();
    for (int j = 0; j < maxJoints; ++j) {
      const auto joint = static_cast<JointId>(j);
      if (robot.model.has(joint) && robot.motors.touches(joint))
        world_->setJointVelocity(handle, joint, robot.motors.velocity(joint));
    }
    if (!config_.lastingCommands) robot.motors.forgetCommands();
  }
  world_->step();
  for (auto& [handle, robot] : robots_) read(handle, true);
}

void EffectsWorld::reset() {
  world_->reset();
  robots_.clear();
}

const RobotReadings& EffectsWorld::readings(RobotHandle robot) const {
  const auto found = robots_.find(robot);
  return found == robots_.end() ? world_->readings(robot) : found->second.readings;
}

}  // namespace plumbline::simulation
