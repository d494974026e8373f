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

/// What such sensors make of a channel's true values; the same for a seed and the channel's name.
void addNoise(const Signal& signal, const SensorNoise& noise, std::uint64_t seed,
              std::vector<double>& values);

/// What such sensors leave in doubt of one reading: standard deviation, quantisation included.
double noiseOf(const Signal& signal, const SensorNoise& noise = {});

struct SimulatedRecordingOptions {
  Explanation effects;  ///< what this robot has and its nominal model has not
  SensorNoise noise;
  bool noisy = true;
  bool truth = false;      ///< truth.* columns of a free robot as well
  double rateHz = 0;       ///< 0: the robot's control rate
  std::uint64_t seed = 1;  ///< of noise and lost commands
  double step = 0.001;     ///< of the integrator, finer than the diagnosis takes [s]
};

/// A program played on a robot that the project's own dynamics simulate (replay/Replay.h): hung up, or put on
/// its feet, and settled in the first posture. Channels: cmd, pos, and of a robot with an IMU gyro and acc,
/// of a free one with force sensors fsr. The run has no folder yet. Same options, same numbers.
Run recordSimulated(const Mechanism& robot, const Excitation& program,
                    const SimulatedRecordingOptions& options = {});

/// What plays a trial's commands on a plant; cycles that are lost have a 1 (none where it is empty).
using TrialPlayer =
    std::function<Prediction(const Plant&, const Trial&, const std::vector<std::uint8_t>& lost)>;

/// The same with another simulation than replay/.
Run recordWith(const Mechanism& robot, const Excitation& program, const SimulatedRecordingOptions& options,
               const TrialPlayer& player);

/// The run's commands with nothing measured yet: every channel that a recording of it would have is NaN.
Run blankRun(const Mechanism& robot, const Excitation& program, double rateHz, bool truth = false);

}  // namespace plumbline::gap
