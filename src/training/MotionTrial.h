#pragma once
#include "robot/JointVelocityControl.h"
#include "simulation/league/LocalRobot.h"
#include "training/MotionDriver.h"

namespace plumbline::training {

/// A robot in its own world in this process, controlled as by the agent: targets through the joint control,
/// one cycle of delay, angles rounded as by the server. For searches, tests and benchmarks of motions.
class MotionTrial : public MotionDriver {
public:
  /// config: of its world, effects among it.
  explicit MotionTrial(int type, const simulation::WorldConfig& config = {});

  const simulation::RobotReadings& readings() const override { return robot.sense(); }
  Pose3 torsoPose() const override { return robot.torso().pose; }

  /// Throws the robot over: it is put down tilted forward (1), backward (-1) or sideways (0), with its joints
  /// anywhere near the walk's and moving, and falls until it has lain for a moment. False if it did not fall.
  bool fall(int direction);
  /// Pushes the robot forward (1), backward (-1) or sideways (0) while it walks; it walks on until it has
  /// lain for a moment, as in play. False if it did not fall.
  bool stumble(int direction);

  /// After the robot was put somewhere: nothing of what was before has an effect from now on.
  void restarted();

  /// A moment that a run can begin with.
  struct State {
    simulation::BodyState torso;
    JointArray angles{}, rates{};  ///< [rad, rad/s]
    void stop();                   ///< sets all velocities to 0
  };
  State state() const { return {robot.torso(), robot.sense().angle, rates()}; }
  /// Puts the robot into a state; nothing of what was before has an effect from now on.
  void begin(const State& state);

  simulation::LocalRobot robot;
  JointVelocityControl control;
  double standingHeight = 0;  ///< of the torso [m]

private:
  void move(const JointArray& targets) override;
  JointArray rates() const;  ///< over the last cycle [rad/s]

  JointArray lastAngles_{};  ///< before the last cycle [rad]
};

}  // namespace plumbline::training
