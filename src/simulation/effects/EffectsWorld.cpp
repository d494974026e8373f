#include "simulation/effects/EffectsWorld.h"

#include <cmath>

#include "simulation/effects/BodyEffects.h"
#include "simulation/effects/EffectTable.h"

namespace plumbline::simulation {

EffectsWorld::EffectsWorld(std::unique_ptr<World> world_, const WorldConfig& config_)
    : world(std::move(world_)), config(config_) {
  checkEffects(config.effects);
}

void EffectsWorld::read(RobotHandle handle, bool newCycle) {
  Robot& robot = get(handle);
  JointArray slack{};
  for (int j = 0; j < maxJoints; ++j)
    slack[static_cast<std::size_t>(j)] = robot.motors.slack(static_cast<JointId>(j));
  robot.readings = robot.sensors.read(world->readings(handle), slack, newCycle);
}

RobotHandle EffectsWorld::addRobot(const RobotModel& model, const Pose3& T_world_torso) {
  const RobotHandle handle = world->addRobot(withEffects(model, config.effects), T_world_torso);
  robots.insert_or_assign(
      handle, Robot{model,
                    MotorEffects(config.effects, config.stepSeconds, static_cast<std::uint64_t>(handle)),
                    SensorEffects(config.effects, config.stepSeconds),
                    {}});
  read(handle, false);
  return handle;
}

void EffectsWorld::removeRobot(RobotHandle robot) {
  world->removeRobot(robot);
  robots.erase(robot);
}

void EffectsWorld::moveRobot(RobotHandle robot, const Pose3& T_world_torso) {
  world->moveRobot(robot, T_world_torso);
  read(robot, false);
}

void EffectsWorld::setPosture(RobotHandle robot, const JointArray& angles) {
  world->setPosture(robot, angles);
  get(robot).motors.restart();
  get(robot).sensors.restart();
  read(robot, false);
}

void EffectsWorld::setState(RobotHandle robot, const BodyState& torso, const JointArray& angles,
                            const JointArray& rates) {
  world->setState(robot, torso, angles, rates);
  read(robot, false);
}

void EffectsWorld::setVelocities(RobotHandle robot, const BodyState& torso, const JointArray& rates) {
  world->setVelocities(robot, torso, rates);
  read(robot, false);
}

void EffectsWorld::setJointVelocity(RobotHandle handle, JointId joint, double velocity) {
  if (joint >= 0 && joint < maxJoints && get(handle).motors.touches(joint)) {
    Robot& robot = get(handle);
    // What the world refuses, it refuses at once.
    if (!robot.model.has(joint) || !std::isfinite(velocity)) world->setJointVelocity(handle, joint, velocity);
    robot.motors.command(joint, velocity);
    return;
  }
  world->setJointVelocity(handle, joint, velocity);
}

void EffectsWorld::step() {
  for (auto& [handle, robot] : robots) {
    robot.motors.beginCycle();
    for (int j = 0; j < maxJoints; ++j) {
      const auto joint = static_cast<JointId>(j);
      if (robot.model.has(joint) && robot.motors.touches(joint))
        world->setJointVelocity(handle, joint, robot.motors.velocity(joint));
    }
    if (!config.lastingCommands) robot.motors.forgetCommands();
  }
  world->step();
  for (auto& [handle, robot] : robots) read(handle, true);
}

void EffectsWorld::reset() {
  world->reset();
  robots.clear();
}

const RobotReadings& EffectsWorld::readings(RobotHandle robot) const {
  const auto found = robots.find(robot);
  return found == robots.end() ? world->readings(robot) : found->second.readings;
}

}  // namespace plumbline::simulation
