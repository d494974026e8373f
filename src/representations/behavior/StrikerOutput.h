#pragma once
#include "representations/behavior/BehaviorOutput.h"

namespace plumbline {

/// The player at the ball.
REPRESENTATION_OF(StrikerOutput, BehaviorOutput)
class StrikerOutput : public StrikerOutputBase {};

}  // namespace plumbline
