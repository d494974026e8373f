#pragma once
#include "representations/behavior/BehaviorOutput.h"

namespace plumbline {

/// Waiting for a kick-off.
REPRESENTATION_OF(BeforeKickOffOutput, BehaviorOutput)
class BeforeKickOffOutput : public BeforeKickOffOutputBase {};

}  // namespace plumbline
