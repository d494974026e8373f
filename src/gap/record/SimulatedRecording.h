#pragma once
#include <cstdint>
#include <functional>

#include "gap/diagnosis/Explanation.h"
#include "gap/record/Excitation.h"
#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"
#include "gap/run/Run.h"

namespace plumbline::gap {

/// What a simulated robot's sensors add to the truth; the defaults are those of a NAO.
struct SensorNoise {
  double encoderStep = 2 * 3.14159265358979323846 / 4096;  ///< [rad]
  double encoder = 3e-4;                                   ///< standard deviation [rad]
  double gyro = 0.005;                                     ///< [rad/s]
  double accelerometer = 0.06;                             ///< [m/s^2]
  double force = 0.15;                                     ///< [N]; a force sensor never reads below 0
};

/// Adds the sensors' noise to a channel's true values; it depends only on the seed and the channel's name.
void addNoise(const Signal& signal, const SensorNoise& noise, std::uint64_t seed,
              std::vector<double>& values);

/// Uncertainty of one reading of such sensors: standard deviation, including quantisation.
double noiseOf(const Signal& signal, const SensorNoise& noise = {});

struct SimulatedRecordingOptions {
  Explanation effects;  ///< effects that this robot has and its nominal model does not
  SensorNoise noise;
  bool noisy = true;
  bool truth = false;      ///< also record truth.* columns of a free robot
  double rateHz = 0;       ///< 0: the robot's control rate
  std::uint64_t seed = 1;  ///< of noise and lost commands
  double step = 0.001;     ///< of the integrator, finer than in the diagnosis [s]
};

/// Plays a program on a robot that the project's own dynamics simulate (replay/Replay.h), hung up or put on
/// its feet, and settled in the first posture. Channels: cmd, pos; gyro and acc of a robot with an IMU; fsr
/// of a free robot with force sensors. The run has no folder yet. The same options give the same numbers.
Run recordSimulated(const Mechanism& robot, const Excitation& program,
                    const SimulatedRecordingOptions& options = {});

/// Function that plays a trial's commands on a plant; lost cycles have a 1 (an empty list: none is lost).
using TrialPlayer =
    std::function<Prediction(const Plant&, const Trial&, const std::vector<std::uint8_t>& lost)>;

/// The same with another simulation than replay/.
Run recordWith(const Mechanism& robot, const Excitation& program, const SimulatedRecordingOptions& options,
               const TrialPlayer& player);

/// The run's commands before any measurement: every channel of the recording is NaN.
Run blankRun(const Mechanism& robot, const Excitation& program, double rateHz, bool truth = false);

}  // namespace plumbline::gap
