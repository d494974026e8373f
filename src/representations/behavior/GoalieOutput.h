#pragma once
#include "representations/behavior/BehaviorOutput.h"

namespace plumbline {

/// The goalie in its goal.
REPRESENTATION_OF(GoalieOutput, BehaviorOutput)
class GoalieOutput : public GoalieOutputBase {};

}  // namespace plumbline
