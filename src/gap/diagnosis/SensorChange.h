#pragma once
#include "gap/replay/Plant.h"
#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// The readings of the sensors of `after` for the motion that was predicted with those of `before`. Inertial
/// sensor and foot sensors do not influence the motion, so nothing has to be replayed.
Prediction sensorChange(const Plant& before, const Plant& after, const Trial& trial,
                        const Prediction& predicted);

}  // namespace plumbline::gap
