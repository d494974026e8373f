#pragma once
#include <functional>
#include <string>

#include "training/WalkTrial.h"

namespace plumbline::walking {

/// A sprint that ends earlier: the same way from the walk of mixtures towards the full speed of a direction,
/// but only a share of it (0: no sprint, 1: all of it). Speeds on the way are walked as before. Throws
/// std::invalid_argument for Task::mixture.
WalkGaits cutSprint(const WalkGaits& gaits, Task direction, double share);

/// What a sprint has to go through without a single fall to be chosen.
struct ChoiceSetup {
  std::uint64_t seed = 1;
  int holds = 4;            ///< times full speed is held, from a stand
  double holdSeconds = 60;  ///< each
  int tries = 48;           ///< with interruptions, in which anything is asked for (tryWalk)
  double trySeconds = 12;   ///< each
  double push = 0.02;       ///< greatest push in those [m/s]
  double step = 0.1;        ///< shares tried: 1, 1 - step ..
};

/// Whether the sprint of a direction goes through all that without a fall.
bool holds(Walker& robot, const WalkGaits& gaits, Task direction, const ChoiceSetup& setup);

/// The rule by which a sprint is chosen: the longest share of it that goes through without a fall; 0 if none
/// does.
double safeShare(Walker& robot, const WalkGaits& gaits, Task direction, const ChoiceSetup& setup);

}  // namespace plumbline::walking
