#pragma once
#include <cstdint>

#include "training/SprintCut.h"
#include "training/Walker.h"

namespace plumbline::training {

/// How a walk did in a number of tries.
struct WalkTrialResult {
  double speed =
      0;  ///< mean along the request, 0 from a fall on; turning [rad/s], mixture: share of the request
  double falls = 0;     ///< per try; mixture: per minute; push: per try, a small push counting more
  double odometry = 0;  ///< mixture: error of the odometry per metre
  double drift = 0;     ///< speed across the request, or away while turning [m/s]
  /// Of a direction: mean over the tries of the torso's greatest lean (LeanWatch), a fall counting as 1. Of
  /// tries at a cut speed, too, the sum of both means [rad].
  double lean = 0;
};

struct WalkTrialSetup {
  std::uint64_t seed = 1;
  int tries = 10;
  double seconds = 6;     ///< of one try
  double push = 0.1;      ///< greatest change of the body's velocity by a push, about one a second, or
                          ///< where pushes are the task the one of a try [m/s]
  bool stopEarly = true;  ///< gives up when the first tries all end in falls, counting the rest as such
  /// Of a direction: after each try comes a shorter one of the sprint cut to a share that the seed draws
  /// (cutSprint). Every sprint passes through these speeds at its beginning and its end. Only the lean
  /// counts.
  bool alsoCut = false;
};

/// Lets the robot do the task: from standing at full speed for some seconds, then to a stop, with random
/// pushes and small random changes of the request.
WalkTrialResult tryWalk(Walker& robot, const walking::WalkGaits& gaits, WalkTrialKind task,
                        const WalkTrialSetup& setup);

/// The request for more than any walk's full speed in a direction; sign 1 or -1: left or right.
walking::WalkRequest fullSpeed(WalkTrialKind task, double sign);

/// How a walk held a speed.
struct HeldSpeed {
  double speed = 0;  ///< mean along the request from two seconds after the start on [m/s]; turning [rad/s]
  bool upright = true;
};

/// Holds a request for `seconds` after the first two, from standing for `wait` [s] at a place `aside` [m].
/// The simulator has no randomness: from the same place after the same wait a robot does the same. At the end
/// of the field the walking robot is moved back. If it cannot be moved, it starts again where there is most
/// field ahead. The first two seconds never count.
HeldSpeed holdSpeed(Walker& robot, const walking::WalkRequest& request, double seconds, double wait,
                    double aside);

}  // namespace plumbline::training
