#pragma once
#include <array>

#include "walking/parameters/WalkGaits.h"

namespace plumbline::training {

/// What a walk is tried for.
enum class WalkTrialKind { forward, backward, sideways, turn, mixture, push };
inline constexpr std::array<const char*, 6> walkTrialKindNames{"forward", "backward", "sideways",
                                                               "turn",    "mixture",  "push"};

/// Those that have a sprint.
inline constexpr std::array sprintDirections{WalkTrialKind::forward, WalkTrialKind::backward,
                                             WalkTrialKind::sideways, WalkTrialKind::turn};

/// A direction's full speed, and the one up to which it may be mixed with others.
struct SprintSpeeds {
  double walking::SpeedParameters::*most;
  double walking::SpeedParameters::*omni;
};
/// Throws std::invalid_argument for WalkTrialKind::mixture and WalkTrialKind::push.
SprintSpeeds speedsOf(WalkTrialKind direction);

/// A sprint that ends earlier: the same way from the walk of mixtures towards the full speed of a direction,
/// but only a share of it (0: no sprint, 1: all of it). Speeds on the way are walked as before. Throws
/// std::invalid_argument for WalkTrialKind::mixture and WalkTrialKind::push.
walking::WalkGaits cutSprint(const walking::WalkGaits& gaits, WalkTrialKind direction, double share);
/// All of them.
walking::WalkGaits cutSprints(const walking::WalkGaits& gaits, double share);

}  // namespace plumbline::training
