#pragma once
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"
#include "gap/record/EngineRecording.h"

namespace plumbline::gap {

/// Effects outside the library for a robot in an engine (doc/reference/gap-blind.md lists them), at the
/// drives of joints, and the accelerometer's bias. Joints with a common motor have the same effect.
class OutsideDrives : public OutsideEffects {
public:
  /// The robot must outlive it. Throws std::runtime_error for another effect, or a place that the robot does
  /// not have.
  OutsideDrives(const Mechanism& robot, const std::vector<BlindEffect>& effects);

  void start(const std::vector<double>& commands) override;
  void act(double time, double h, simulation::RobotSimulation& world, std::vector<double>& targets) override;
  Vec3 accBias() const override { return bias_; }

private:
  struct Drive {
    double ripple = 0, spring = 0, cable = 0, dampingOneWay = 0, bristle = 0;
    double drift = 0, integral = 0, lag = 0, crosstalk = 0;
    double rest = 0, lagged = 0, summed = 0, bristleAt = 0;
  };
  /// The member to which an effect's value is added.
  static double Drive::*sizeOf(const std::string& effect);
  double torque(Drive& drive, double q, double speed) const;
  double targetFor(Drive& drive, std::size_t joint, double time, double h, double measured,
                   const std::vector<double>& targets) const;

  const Mechanism& robot_;
  std::vector<Drive> drives_;
  Vec3 bias_ = Vec3::Zero();
};

}  // namespace plumbline::gap
