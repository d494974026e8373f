#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "gap/blind/BlindCase.h"
#include "gap/effects/DrawRange.h"
#include "gap/record/EngineRecording.h"

namespace plumbline::gap {

/// The drive of one joint: sizes of its effects, and their state.
struct OutsideDrive {
  double ripple = 0, spring = 0, cable = 0, dampingOneWay = 0, bristle = 0;
  double drift = 0, integral = 0, resolution = 0, crosstalk = 0;
  double rest = 0, summed = 0, bristleAt = 0;
};

/// An effect outside the library (doc/reference/gap-blind.md): how it is drawn, and what its value is added
/// to.
struct OutsideEffect {
  std::string_view id;
  DrawRange drawing;
  double OutsideDrive::*size = nullptr;  ///< null: the accelerometer's bias
};

/// All of them, in the order in which they are drawn.
std::span<const OutsideEffect> outsideEffects();

/// Null if there is none of that id.
const OutsideEffect* findOutsideEffect(std::string_view id);

/// Effects outside the library for a robot in an engine, at the drives of joints, and the accelerometer's
/// bias. Joints with a common motor have the same effect.
class OutsideDrives : public OutsideEffects {
public:
  /// The robot must outlive it. Throws std::runtime_error for another effect, or a place that the robot does
  /// not have.
  OutsideDrives(const Mechanism& robot, const std::vector<BlindEffect>& effects);

  void start(const std::vector<double>& commands) override;
  void act(double time, double h, servo::RobotSimulation& world, std::vector<double>& targets) override;
  Vec3 accBias() const override { return bias_; }

private:
  double torque(OutsideDrive& drive, double q, double speed) const;
  double targetFor(OutsideDrive& drive, std::size_t joint, double time, double h, double measured,
                   const std::vector<double>& targets) const;

  const Mechanism& robot_;
  std::vector<OutsideDrive> drives_;
  Vec3 bias_ = Vec3::Zero();
};

}  // namespace plumbline::gap
