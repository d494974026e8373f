#pragma once
#include <map>
#include <memory>
#include <vector>

#include "simulation/effects/MotorEffects.h"
#include "simulation/effects/SensorEffects.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// A world whose robots have effects that are not in their models; for its users it is an ordinary world.
/// Effects of the ground and of torque are in the world itself (LeaguePhysics).
class EffectsWorld : public World {
public:
  /// Throws ConfigurationError for effects that these robots cannot have.
  EffectsWorld(std::unique_ptr<World> world, const WorldConfig& config);

  RobotHandle addRobot(const RobotModel& model, const Pose3& T_world_torso) override;
  void removeRobot(RobotHandle robot) override;
  void moveRobot(RobotHandle robot, const Pose3& T_world_torso) override;
  void setPosture(RobotHandle robot, const JointArray& angles) override;
  void setState(RobotHandle robot, const BodyState& torso, const JointArray& angles,
                const JointArray& rates) override;
  void setVelocities(RobotHandle robot, const BodyState& torso, const JointArray& rates) override;
  void setJointVelocity(RobotHandle robot, JointId joint, double velocity) override;
  void step() override;
  void reset() override;
  const RobotReadings& readings(RobotHandle robot) const override;
  BodyState linkState(RobotHandle robot, int link) const override { return world_->linkState(robot, link); }
  BodyState torso(RobotHandle robot) const override { return world_->torso(robot); }
  BodyState ball() const override { return world_->ball(); }
  void setBall(const Vec3& position, const Vec3& velocity) override { world_->setBall(position, velocity); }
  void setBall(const BodyState& state) override { world_->setBall(state); }
  const std::vector<RobotHandle>& ballTouchedBy() const override { return world_->ballTouchedBy(); }
  const std::vector<RobotContact>& robotContacts() const override { return world_->robotContacts(); }

private:
  struct Robot {
    RobotModel model;
    MotorEffects motors;
    SensorEffects sensors;
    RobotReadings readings;
  };
  Robot& get(RobotHandle robot) { return robots_.at(robot); }
  void read(RobotHandle handle, bool newCycle);

  std::unique_ptr<World> world_;
  WorldConfig config_;
  std::map<RobotHandle, Robot> robots_;
};

}  // namespace plumbline::simulation
