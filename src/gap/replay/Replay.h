#pragma once
#include <cstdint>
#include <vector>

#include "gap/replay/Plant.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

struct ReplayOptions {
  /// Joints to move, closed under what carries them; empty: all. With a held base chains do not feel each
  /// other, so an effect at a joint needs its chain alone.
  std::vector<int> joints;
  double step = 0.002;      ///< longest step of the integrator [s]
  double gearStep = 0.001;  ///< the same where a gear has play or gives way [s]
  double settle = 1;  ///< the first command is held so long before the run begins [s]; 0: starts as measured
  bool restarts = true;  ///< goes on from what was measured wherever the trial says; false: in one piece
  const std::vector<std::uint8_t>* lostCycles = nullptr;  ///< per cycle: its command never came
};

/// What the plant would have measured: one vector per signal of the trial, NaN for what is not predicted
/// (joints left out, truth of a held base).
struct Prediction {
  std::vector<std::vector<double>> values;
  /// What cannot be predicted of them: variance per signal and cycle; empty where nothing is uncertain.
  std::vector<std::vector<double>> scatter;
  bool fell = false;  ///< a free robot's torso tilted by more than 60 degrees
};

/// Plays a trial's commands on a plant. Second-order linearly implicit midpoint steps; dry friction and
/// contacts as bounds on impulses (velocity-level complementarity), solved exactly for one joint and by
/// projected Gauss-Seidel for more. Same inputs, same bytes. Throws Stopped (framework/StopSignal.h) once a
/// caught signal has come.
Prediction replay(const Plant& plant, const Trial& trial, const ReplayOptions& options = {});

}  // namespace plumbline::gap
