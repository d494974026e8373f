#pragma once
#include <memory>

#include "math/Random.h"
#include "training/ServoPlant.h"

namespace plumbline::reality {
class World;
}

namespace plumbline::bench {

/// A robot with position servos in MuJoCo, the walk's second reality: another engine, other contacts, and
/// sensors as a real one's (an encoder of 4096 counts a turn, noise on angles, IMU and forces). The servo law
/// is that of the robot file; a joint that another's motor drives has a servo of its own with that one's
/// command.
class MujocoPlant : public walking::ServoPlant {
public:
  explicit MujocoPlant(const Mechanism& robot);
  ~MujocoPlant() override;

  void restart(const std::vector<double>& posture, double heading) override;
  const walking::ServoMeasurement& measure() override { return measured; }
  void command(const walking::ServoCommand& command) override { valid = command; }
  void push(const Vec3& force) override;
  void step() override;
  Pose3 torso() const override;
  Vec3 comVelocity() const override;

private:
  void actuate();
  void sense();

  Mechanism robot;
  int substeps;
  std::unique_ptr<reality::World> world;
  walking::ServoCommand valid;
  walking::ServoMeasurement measured;
  Vec3 gyro = Vec3::Zero(), acc = Vec3::Zero();  ///< mean over the cycle
  Random random{1};
};

}  // namespace plumbline::bench
