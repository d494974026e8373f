#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "RealityEffect.h"
#include "gap/record/Excitation.h"
#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::reality {

struct RealityOptions {
  double step = 2e-4;  ///< [s]
  bool noise = true;
  bool truth = false;                                                           ///< adds truth.* columns
  double encoderStep = 2 * 3.14159265358979323846 / 4096, encoderNoise = 3e-4;  ///< [rad]
  double gyroNoise = 0.005, accNoise = 0.06, forceNoise = 0.15;                 ///< [rad/s, m/s^2, N]
};

/// A robot with effects in MuJoCo, which plays programs and records runs as a real one would: the reality of
/// the diagnosis's benchmark.
class Reality {
public:
  /// Throws std::runtime_error where effects do not fit the robot or the engine refuses the model.
  Reality(const Mechanism& robot, std::vector<RealityEffect> effects, RealityOptions options = {});

  /// Plays a program from rest (1 s held, standing 2 s); `seed` draws noise and lost commands.
  gap::Run record(const gap::Excitation& program, std::uint64_t seed) const;

private:
  const Mechanism robot_;  ///< nominal
  const std::vector<RealityEffect> effects_;
  const RealityOptions options_;
};

}  // namespace plumbline::reality
