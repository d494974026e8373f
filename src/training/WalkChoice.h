#pragma once
#include <functional>
#include <string>
#include <vector>

#include "training/SprintCut.h"
#include "training/WalkTrial.h"

namespace plumbline::training {

/// The rule by which a walk is chosen from what searches found: the fastest of it that goes through all this
/// without a single fall.
struct ChoiceSetup {
  std::uint64_t seed = 1;
  double minutes = 40;           ///< of random requests, a minute from each stand
  int tries = 24;                ///< of a sprint that random requests interrupt (tryWalk)
  double trySeconds = 12;        ///< each
  double push = 0.02;            ///< greatest push in those [m/s]
  int holds = 12;                ///< times a sprint is held, from a stand; to either side in turn
  double holdSeconds = 60;       ///< each
  double sprintStep = 0.05;      ///< shares of a sprint that are tried: 1, 1 - sprintStep ..
  double mixStep = 0.1;          ///< the same of the speeds that may be mixed, down to half of them
  double fallsPerMinute = 0.05;  ///< at most under random requests, of the walk with its sprints
};

/// The walk with another one's sprint of a direction.
walking::WalkGaits withSprint(const walking::WalkGaits& gaits, const walking::WalkGaits& other,
                              WalkTrialKind direction);

/// Speeds that may be mixed, all times this; full speeds as they are.
walking::WalkGaits slowMixture(const walking::WalkGaits& gaits, double share);

/// Falls per minute under random requests, at most about `enough`: it stops counting there.
double randomFalls(Walker& robot, const walking::WalkGaits& gaits, const ChoiceSetup& setup, double enough);

/// Whether the sprint of a direction is held and can be interrupted without a fall.
bool sprintHolds(Walker& robot, const walking::WalkGaits& gaits, WalkTrialKind direction,
                 const ChoiceSetup& setup);

/// The longest share of a sprint that holds; 0 if none does.
double safeShare(Walker& robot, const walking::WalkGaits& gaits, WalkTrialKind direction,
                 const ChoiceSetup& setup);

/// The mixture slowed down until random requests without sprints make no fall.
walking::WalkGaits chooseMixture(Walker& robot, const walking::WalkGaits& gaits, const ChoiceSetup& setup,
                                 const std::function<void(const std::string&)>& say);

/// The first walk with the fastest of several walks' sprints of a direction, each cut to its safe share;
/// without if none is quicker than nothing.
walking::WalkGaits chooseSprint(Walker& robot, const walking::WalkGaits& gaits,
                                const std::vector<walking::WalkGaits>& others, WalkTrialKind direction,
                                const ChoiceSetup& setup, const std::function<void(const std::string&)>& say);

/// All sprints cut by the same share until random requests make no more falls than is allowed.
walking::WalkGaits chooseTogether(Walker& robot, const walking::WalkGaits& gaits, const ChoiceSetup& setup,
                                  const std::function<void(const std::string&)>& say);

}  // namespace plumbline::training
