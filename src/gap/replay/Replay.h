#pragma once
#include <cstdint>
#include <vector>

#include "gap/replay/Plant.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

struct ReplayOptions {
  /// Joints to move, including those that carry them; empty: all. With a fixed base chains do not influence
  /// each other, so an effect at a joint needs only its chain.
  std::vector<int> joints;
  double step = 0.002;      ///< longest step of the integrator [s]; it may span cycles of a faster log
  double gearStep = 0.001;  ///< the same if a gear has backlash or compliance [s]
  double settle = 1;  ///< time for which the first command is held before the run [s]; 0: starts as measured
  bool restarts = true;  ///< restarts from the measured state where the trial says; false: in one piece
  /// Per cycle: its command was lost; null: what the trial knows.
  const std::vector<std::uint8_t>* lostCycles = nullptr;
  bool asSent = false;  ///< as if the trial knew of no lost command
  /// Steps are as long as they may be and need not end with cycles; a command counts by its share of a step.
  bool acrossCycles = false;
};

/// For differences of replays, which hardly depend on the step: twice the usual ones, across cycles.
inline ReplayOptions withLongSteps() {
  ReplayOptions options;
  options.step *= 2;
  options.gearStep *= 2;
  options.acrossCycles = true;
  return options;
}

/// Predicted readings of the plant: one vector per signal of the trial, NaN if not predicted (joints left
/// out, truth of a fixed base).
struct Prediction {
  std::vector<std::vector<double>> values;
  /// Unpredictable part: variance per signal and cycle; empty if nothing is uncertain.
  std::vector<std::vector<double>> variance;
  bool fell = false;  ///< a free robot's torso tilted by more than 60 degrees
};

/// Plays a trial's commands on a plant. Second-order linearly implicit midpoint steps; dry friction and
/// contacts as bounds on impulses (velocity-level complementarity), solved exactly for one joint and by
/// projected Gauss-Seidel for more. The same inputs give the same bytes. Throws Stopped
/// (framework/StopSignal.h) after a caught signal.
Prediction replay(const Plant& plant, const Trial& trial, const ReplayOptions& options = {});

}  // namespace plumbline::gap
