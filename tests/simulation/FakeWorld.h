#pragma once
#include <map>
#include <vector>

#include "robot/ForwardKinematics.h"
#include "simulation/world/World.h"

namespace plumbline::test {

/// A world with a ball and robots that stay where they are put: no physics, for tests of what judges it.
class FakeWorld : public simulation::World {
public:
  struct Robot {
    RobotModel model;
    simulation::BodyState torso;
    JointArray angles{};
    JointArray commanded{};
    int moves = 0;
  };
  simulation::BodyState ballState;
  std::map<simulation::RobotHandle, Robot> robots;
  std::vector<simulation::RobotHandle> touches;
  std::vector<simulation::RobotContact> contacts;
  int ballsPlaced = 0;

  simulation::RobotHandle addRobot(const RobotModel& model, const Pose3& T_world_torso) override {
    const auto handle = static_cast<simulation::RobotHandle>(robots.size());
    robots[handle] = {model, {T_world_torso, Vec3::Zero(), Vec3::Zero()}, {}, {}, 0};
    return handle;
  }
  void removeRobot(simulation::RobotHandle robot) override { robots.erase(robot); }
  void moveRobot(simulation::RobotHandle robot, const Pose3& T_world_torso) override {
    robots.at(robot).torso = {T_world_torso, Vec3::Zero(), Vec3::Zero()};
    ++robots.at(robot).moves;
  }
  void setPosture(simulation::RobotHandle robot, const JointArray& angles) override {
    robots.at(robot).angles = angles;
  }
  void setState(simulation::RobotHandle, const simulation::BodyState&, const JointArray&,
                const JointArray&) override {}
  void setVelocities(simulation::RobotHandle, const simulation::BodyState&, const JointArray&) override {}
  void setJointVelocity(simulation::RobotHandle robot, JointId joint, double velocity) override {
    robots.at(robot).commanded[static_cast<std::size_t>(joint)] = velocity;
  }
  void step() override {}
  void reset() override { robots.clear(); }
  const simulation::RobotReadings& readings(simulation::RobotHandle) const override { return noReadings_; }
  simulation::BodyState linkState(simulation::RobotHandle robot, int link) const override {
    const Robot& r = robots.at(robot);
    ForwardKinematics kinematics(r.model);
    kinematics.update(r.angles);
    const Vec3& com = r.model.links[static_cast<std::size_t>(link)].com;
    return {r.torso.pose * kinematics.link(link) * translation(com), Vec3::Zero(), Vec3::Zero()};
  }
  simulation::BodyState torso(simulation::RobotHandle robot) const override { return robots.at(robot).torso; }
  simulation::BodyState ball() const override { return ballState; }
  void setBall(const Vec3& position, const Vec3& velocity) override {
    ballState.pose = translation(position);
    ballState.linearVelocity = velocity;
    ++ballsPlaced;
  }
  void setBall(const simulation::BodyState& state) override { ballState = state; }
  const std::vector<simulation::RobotHandle>& ballTouchedBy() const override { return touches; }
  const std::vector<simulation::RobotContact>& robotContacts() const override { return contacts; }

private:
  simulation::RobotReadings noReadings_;
};

}  // namespace plumbline::test
