#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "training/WalkTrial.h"

namespace plumbline::training {

/// One number of the walk that is searched: a parameter of the base (section ""), of a corner or of the
/// recovery from pushes.
struct WalkVariable {
  std::string section;
  const walking::WalkParameter* parameter;
  double step;  ///< a sensible first change
};

/// Throws ConfigurationError naming the nearest one for a path that no parameter of the walk has.
void checkWalkParameters(const std::vector<std::string>& paths);

/// What is searched for a task, as config/search_steps.yaml has it: the corner of a direction with its speed
/// and acceleration; for the mixture the accelerations, the feedback and the speeds; for pushes the recovery.
std::vector<WalkVariable> variablesOf(WalkTrialKind task);

double valueOf(const walking::WalkGaits& gaits, const WalkVariable& variable);
/// Sets it, within its range; directions that have the base's value follow it; durations of steps of the same
/// section follow stepDuration.
void setValue(walking::WalkGaits& gaits, const WalkVariable& variable, double value);

struct WalkTrainingSetup {
  std::string robot = "type 0";                                              ///< its name in the output
  std::function<std::unique_ptr<Walker>(const walking::WalkGaits&)> walker;  ///< makes the robot
  WalkTrialKind task = WalkTrialKind::forward;
  std::string optimizer = "cmaes";  ///< one of optimizerNames()
  int generations = 100, population = 16;
  std::uint64_t seed = 1;
  WalkTrialSetup trial;
  std::vector<std::string> only;  ///< names of the parameters that are searched; empty: all of the task's
  double sigma = 0.5;             ///< of the first generation, in first steps of the variables
  int jobs = 1;                   ///< candidates tried at a time; their number changes nothing else
  std::string state;  ///< of a search that was interrupted, as `store` got it; empty: from the beginning
  std::function<void(const std::string&)> store;  ///< the search's state after each generation
  /// What is being done, and which share of it is done.
  std::function<void(const std::string&, double)> report;
};

/// What a walk costs: lower is better [m/s]. A direction pays for its lean, in which a fall is the largest;
/// falls weigh more than any speed they could be worth.
double walkCost(WalkTrialKind task, const WalkTrialResult& result);

/// Searches with an optimiser from the gaits given, every generation with tries of its own. Returns the
/// middle of the last generation if it is better than the gaits given over many tries that neither was chosen
/// by; else those. progress: a line to print and the best guess so far, every ten generations and at the end.
walking::WalkGaits trainWalk(
    const walking::WalkGaits& gaits, const WalkTrainingSetup& setup,
    const std::function<void(const std::string&, const walking::WalkGaits&)>& progress);

/// The corners of another robot's walk and its speeds and accelerations, with hips as much higher as this
/// robot's are on the spot.
walking::WalkGaits withCornersOf(const walking::WalkGaits& gaits, const walking::WalkGaits& other);

/// The file robots/simspark_typeN/walking.yaml: what is different from the common walk.
std::string walkFile(const walking::WalkGaits& gaits, const walking::WalkParameters& common,
                     const std::string& heading);

}  // namespace plumbline::training
