#pragma once
#include "gap/replay/Plant.h"
#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// What the sensors of `after` show for the motion predicted with those of `before`: inertial sensor and foot
/// sensors only report a motion, so nothing has to be replayed.
Prediction sensorChange(const Plant& before, const Plant& after, const Trial& trial,
                        const Prediction& predicted);

}  // namespace plumbline::gap
