#pragma once
#include "representations/behavior/BehaviorOutput.h"

namespace plumbline {

/// A player without the ball at its place.
REPRESENTATION_OF(SupporterOutput, BehaviorOutput)
class SupporterOutput : public SupporterOutputBase {};

}  // namespace plumbline
