#pragma once
#include "robot/WalkLimits.h"

namespace plumbline::test {

/// Limits of a walk as the league's robots have them.
inline constexpr WalkLimits someWalk{.forward = 0.6,
                                     .backward = 0.4,
                                     .sideways = 0.3,
                                     .turn = 2,
                                     .accelerationForward = 1,
                                     .decelerationForward = 1,
                                     .accelerationSideways = 0.5,
                                     .accelerationTurn = 8};

}  // namespace plumbline::test
