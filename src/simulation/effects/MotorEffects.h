#pragma once
#include <memory>
#include <vector>

#include "simulation/effects/CommandEffect.h"

namespace plumbline::simulation {

/// What happens to one robot's commanded speeds on their way to its joints: each command effect in its turn.
class MotorEffects {
public:
  /// `stream`: of the random numbers, one per robot.
  MotorEffects(const std::vector<EffectSetting>& effects, double stepSeconds, std::uint64_t stream);

  /// Whether a joint's command is changed at all.
  bool touches(JointId joint) const;
  /// Command of a joint from this cycle on [rad/s].
  void command(JointId joint, double velocity) { commanded_[joint] = velocity; }
  /// Takes the commands to where they are a cycle later: velocity() is what each joint does then.
  void beginCycle();
  double velocity(JointId joint) const { return arrived_[joint]; }
  /// Angle of the motor less that of the link [rad].
  double slack(JointId joint) const;
  /// Commands are for one cycle only where a world has it so.
  void forgetCommands() { commanded_.fill(0); }
  /// At rest, nothing under way.
  void restart();

private:
  std::vector<std::unique_ptr<CommandEffect>> effects_;
  JointArray commanded_{}, arrived_{};
};

}  // namespace plumbline::simulation
