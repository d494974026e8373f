#pragma once
#include <vector>

#include "math/TorsoAngleFilter.h"
#include "robot/HumanoidModel.h"
#include "walking/engine/ServoLead.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline::walking {

/// What a robot with position servos measures in a control cycle, in the order of its Mechanism.
struct ServoMeasurement {
  std::vector<double> position;                ///< per joint [rad]
  Vec3 gyro = Vec3::Zero();                    ///< in the sensor's axes [rad/s]
  Vec3 acc = Vec3::Zero();                     ///< specific force, in the sensor's axes [m/s^2]
  std::vector<std::vector<double>> footForce;  ///< per foot and sensor [N]
};

/// Between the walk and any robot with position servos, simulated or not: joint targets in (ServoLead), joint
/// angles, IMU and the forces on the soles out.
class PositionServoAdapter {
public:
  /// Throws std::invalid_argument for a robot that is no humanoid (Humanoid) or has other than two feet.
  explicit PositionServoAdapter(const Mechanism& mechanism);
  PositionServoAdapter(const PositionServoAdapter&) = delete;
  PositionServoAdapter& operator=(const PositionServoAdapter&) = delete;

  const Humanoid& humanoid() const { return lead_.humanoid(); }
  double cycle() const { return 1 / lead_.mechanism().controlHz; }  ///< [s]

  void reset();
  WalkSensors sense(const ServoMeasurement& measured);
  /// p: the walk's parameters now; sensors: as the walk got them.
  const ServoCommand& command(const WalkOutput& output, const WalkParameters& p, const WalkSensors& sensors);

private:
  ServoLead lead_;
  std::array<std::size_t, 2> feet_;  ///< left, right in Mechanism::feet
  TorsoAngleFilter filter_;
};

}  // namespace plumbline::walking
