#pragma once
#include <map>
#include <memory>
#include <vector>

#include "simulation/physics/Physics.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// The league's soccer world on a physics engine.
class SoccerWorld : public World {
public:
  explicit SoccerWorld(const WorldConfig& config);

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
  const RobotReadings& readings(RobotHandle robot) const override { return get(robot).readings; }
  BodyState linkState(RobotHandle robot, int link) const override { return physics_->bodyState(robot, link); }
  BodyState torso(RobotHandle robot) const override;
  BodyState ball() const override { return physics_->bodyState(ballHandle_, 0); }
  void setBall(const Vec3& position, const Vec3& velocity) override;
  void setBall(const BodyState& state) override;
  const std::vector<RobotHandle>& ballTouchedBy() const override { return touchedBall_; }
  const std::vector<RobotContact>& robotContacts() const override { return touchedRobots_; }

private:
  struct Robot {
    RobotModel model;
    RobotReadings readings;
    Vec3 lastVelocity = Vec3::Zero();
    std::vector<std::pair<int, std::optional<FootForce> RobotReadings::*>>
        feet;  ///< links with force sensors
  };

  Robot& get(RobotHandle robot);
  const Robot& get(RobotHandle robot) const;
  static AssemblyState toAssemblyState(const Robot& robot, const BodyState& torso, const JointArray& angles,
                                       const JointArray& rates);
  void stopMotors(RobotHandle robot);
  void senseAcceleration(RobotHandle handle, Robot& robot) const;
  void senseAngles(RobotHandle handle, Robot& robot) const;
  void senseFeet(RobotHandle handle, Robot& robot) const;

  WorldConfig config_;
  std::unique_ptr<Physics> physics_;
  Vec3 gravityForce_ = Vec3::Zero();  ///< per mass, world [m/s^2]
  int ballHandle_ = 0;
  std::map<RobotHandle, Robot>
      robots_;  ///< by the assembly's handle; ordered, so that nothing depends on addresses
  std::vector<RobotHandle> touchedBall_;
  std::vector<RobotContact> touchedRobots_;
};

}  // namespace plumbline::simulation
