#pragma once
#include <memory>

#include "math/Pose2.h"
#include "robot/RobotModel.h"
#include "simulation/referee/FrozenLimbs.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// One robot alone in a world of its own, in this process, with the league server's delay. What is answered
/// to one message shows in the joint angles of the message after the next. Limbs that pass through each other
/// freeze (rule selfCollision). For learning and closed-loop tests; an object is used by one thread at
/// a time.
class LocalRobot {
public:
  explicit LocalRobot(const RobotModel& model, const WorldConfig& config = {});

  /// The message of this cycle.
  const RobotReadings& sense() const { return world_->readings(handle_); }
  /// Answers it with joint velocities [rad/s] (those of joints the robot lacks are ignored) and lets a cycle
  /// pass.
  void act(const JointArray& velocities);

  /// Restarts: the robot stands on the ground at a place of the field with these joint angles, torso upright,
  /// at rest. Nothing from before has an effect afterwards.
  void restart(const Pose2& place = {}, const JointArray& angles = {});
  /// Restarts with the torso at this pose, wherever the feet are.
  void restart(const Pose3& T_world_torso, const JointArray& angles);

  BodyState torso() const { return world_->torso(handle_); }
  /// Whether the torso leans by more than 60 degrees.
  bool fallen() const { return torso().pose.linear()(2, 2) < 0.5; }
  double time() const { return cycles_ * config_.stepSeconds; }  ///< since the restart [s]
  const RobotModel& model() const { return model_; }
  World& world() { return *world_; }
  RobotHandle robot() const { return handle_; }
  /// Whether limbs pass through each other now.
  bool overlaps() const;
  /// Joints that take no speed now.
  const JointSet& frozen() const { return limbs_.joints(); }

private:
  double lowestPoint() const;

  RobotModel model_;
  WorldConfig config_;
  std::unique_ptr<World> world_;
  RobotHandle handle_ = 0;
  JointArray pending_{};  ///< the answer to the message before this one; without delay: to this one
  FrozenLimbs limbs_;
  long cycles_ = 0;
};

}  // namespace plumbline::simulation
