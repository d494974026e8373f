#pragma once
#include "TwoJointArm.h"
#include "gap/diagnosis/Evidence.h"
#include "gap/replay/Replay.h"

namespace plumbline::gap {

/// A recording of the arm that lost these cycles' commands.
inline Evidence recordedWithout(const std::vector<std::uint8_t>& lost) {
  const Mechanism arm = twoJointArm();
  ReplayOptions options;
  options.lostCycles = &lost;
  return Evidence{{recorded(nominalPlant(arm), armTrial(arm, 6), 5e-4, 7, options)}};
}

/// Squares over noise that the lost cycles leave.
inline double squaresWith(const Evidence& evidence, const std::vector<std::uint8_t>& lost) {
  const Trial& trial = evidence.trials()[0];
  ReplayOptions options;
  options.lostCycles = &lost;
  const Prediction prediction = replay(nominalPlant(*trial.robot), trial, options);
  double sum = 0;
  for (std::size_t s = 0; s < trial.signals.size(); ++s)
    for (std::size_t k = 0; k < trial.cycles(); ++k) {
      const double r = trial.signals[s].values[k] - prediction.values[s][k];
      sum += evidence.weights(0, s)[k] * r * r;
    }
  return sum;
}

}  // namespace plumbline::gap
