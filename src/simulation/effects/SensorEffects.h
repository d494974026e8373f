#pragma once
#include <memory>
#include <vector>

#include "simulation/effects/SensorEffect.h"

namespace plumbline::simulation {

/// What one robot's sensors make of the truth: each sensor effect in its turn.
class SensorEffects {
public:
  /// `stream`: of the random numbers, one per robot.
  SensorEffects(const std::vector<EffectSetting>& effects, double stepSeconds, std::uint64_t stream);

  /// Readings as the robot gets them. slack: per joint, what the encoder on the motor's side of a gear with
  /// play shows beyond the link's angle [rad]. newCycle: a step has passed since the last call.
  RobotReadings read(const RobotReadings& truth, const JointArray& slack, bool newCycle);
  void restart();

private:
  std::vector<std::unique_ptr<SensorEffect>> effects_;
};

}  // namespace plumbline::simulation
