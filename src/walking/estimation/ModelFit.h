#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "walking/estimation/ObservedStep.h"

namespace plumbline::walking {

struct ModelFitOptions {
  std::string optimizer = "cmaes";  ///< one of optimizerNames()
  int population = 20;              ///< as in section 4.3.2
  int generations = 60;
  std::uint64_t seed = 1;
  ModelParameters prediction{};  ///< in use
  bool plan = true;              ///< looks for `parameters`, too
  /// Called after every generation; false ends the fit without a result.
  std::function<bool()> keepGoing{};
};

/// Two sets of the ten: `parameters` also change the plan and must be safe for the walk (FitSafety).
/// `prediction` only predict what the robot will do and have no other condition.
struct ModelFitResult {
  ModelParameters parameters;    ///< those before if not accepted
  bool accepted = false;         ///< predicts the left-out steps better than those before, and the walk stays
  bool rolledBack = false;       ///< the previous set was worse in the test: these are the ones before it
  double change = 0;             ///< of the walk (FitSafety); 1: as much as is safe
  double before = 0, after = 0;  ///< error on the steps it was fitted to
  double leftOutBefore = 0, leftOutAfter = 0;  ///< on every third step, which it was not
  ModelParameters prediction;                  ///< those in use if they predict the left-out steps as well
  bool predicts = false;                       ///< they are new
  double predictionLeftOutBefore = 0, predictionLeftOutAfter = 0;
  std::vector<double> best;            ///< least error of `parameters` after each generation
  std::vector<double> bestPrediction;  ///< and of `prediction` (figure 4.13)

  bool hasNewParameters() const { return accepted || predicts; }
};

/// Mean squared error of the positions and velocities that the model predicts from the beginning of each
/// step; one at an error of 5 mm and 5 cm/s (section 4.3.2).
double predictionError(std::span<const ObservedStep> steps, const ModelParameters& parameters);

/// Fits both sets of ten parameters to observed steps with an optimiser. The result depends on its arguments
/// alone.
ModelFitResult fitModel(std::span<const ObservedStep> steps, const ModelParameters& before,
                        const ModelFitOptions& options = {});

}  // namespace plumbline::walking
