#pragma once
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// What one effect makes of one robot's readings.
class SensorEffect {
public:
  virtual ~SensorEffect() = default;
  /// readings: as the effects before it leave them. motorAngle: per joint, on the motor's side of its gear
  /// [rad]. newCycle: a step has passed since the last call.
  virtual void read(RobotReadings& readings, const JointArray& motorAngle, bool newCycle) = 0;
  virtual void restart() {}
};

}  // namespace plumbline::simulation
