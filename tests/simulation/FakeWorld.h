#pragma once
#include <vector>

#include "simulation/World.h"

namespace plumbline::test {

/// A world with a ball and no physics, for tests of what judges it.
class FakeWorld : public simulation::World {
public:
  simulation::BodyState ballState;
  std::vector<simulation::RobotHandle> touches;
  int ballsPlaced = 0;

  simulation::RobotHandle addRobot(const RobotModel&, const Pose3&) override { return 0; }
  void removeRobot(simulation::RobotHandle) override {}
  void moveRobot(simulation::RobotHandle, const Pose3&) override {}
  void setPosture(simulation::RobotHandle, const JointArray&) override {}
  void setState(simulation::RobotHandle, const simulation::BodyState&, const JointArray&,
                const JointArray&) override {}
  void setVelocities(simulation::RobotHandle, const simulation::BodyState&, const JointArray&) override {}
  void setJointVelocity(simulation::RobotHandle, JointId, double) override {}
  void step() override {}
  void reset() override {}
  const simulation::RobotReadings& readings(simulation::RobotHandle) const override { return noReadings; }
  simulation::BodyState linkState(simulation::RobotHandle, int) const override { return {}; }
  simulation::BodyState torso(simulation::RobotHandle) const override { return {}; }
  simulation::BodyState ball() const override { return ballState; }
  void setBall(const Vec3& position, const Vec3& velocity) override {
    ballState.pose = translation(position);
    ballState.linearVelocity = velocity;
    ++ballsPlaced;
  }
  void setBall(const simulation::BodyState& state) override { ballState = state; }
  const std::vector<simulation::RobotHandle>& ballTouchedBy() const override { return touches; }

private:
  simulation::RobotReadings noReadings;
};

}  // namespace plumbline::test
