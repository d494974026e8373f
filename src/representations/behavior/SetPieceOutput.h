#pragma once
#include "representations/behavior/BehaviorOutput.h"

namespace plumbline {

/// The striker in a set piece: it takes the own one, or waits for the opponents'.
REPRESENTATION_OF(SetPieceOutput, BehaviorOutput)
class SetPieceOutput : public SetPieceOutputBase {};

}  // namespace plumbline
