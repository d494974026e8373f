#pragma once
#include <array>
#include <deque>
#include <limits>
#include <vector>

#include "robot/RobotModel.h"
#include "simulation/world/EffectFile.h"
#include "simulation/world/RandomStream.h"

namespace plumbline::simulation {

/// What happens to one robot's commanded speeds on their way to its joints, in this order: lost cycles
/// (command_dropout), command_delay, servo_gain (a factor on the speed, as the agent's own control loop
/// around a velocity motor makes it), profile_speed, acceleration_limit, backlash (the play is crossed before
/// the link moves; within it the link stands still).
class MotorEffects {
public:
  /// `stream`: of the random numbers, one per robot.
  MotorEffects(const std::vector<EffectSetting>& effects, double stepSeconds, std::uint64_t stream);

  /// Whether a joint's command is changed at all.
  bool touches(JointId joint) const { return lossy() || paths_[joint].used; }
  /// Command of a joint from this cycle on [rad/s].
  void command(JointId joint, double velocity) { commanded_[joint] = velocity; }
  /// Draws this cycle's luck; then velocity() gives what each joint does in it, once per joint.
  void beginCycle();
  double velocity(JointId joint);
  /// Angle of the motor less that of the link [rad].
  double slack(JointId joint) const { return paths_[joint].slack; }
  /// Commands are for one cycle only where a world has it so.
  void forgetCommands() { commanded_.fill(0); }
  /// At rest, nothing under way.
  void restart();

private:
  struct Path {
    bool used = false;
    double delay = 0, gain = 1, acceleration = 0, play = 0;
    double fastest = std::numeric_limits<double>::infinity();  ///< [rad/s]
    std::deque<double> sent;                                   ///< newest first
    double speed = 0, slack = 0;
  };
  bool lossy() const { return dropout_ > 0; }

  double step_, dropout_ = 0;
  RandomStream random_;
  bool lost_ = false;
  JointArray commanded_{}, arrived_{};
  std::array<Path, maxJoints> paths_;
};

}  // namespace plumbline::simulation
