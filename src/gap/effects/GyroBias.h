#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Constant error of the gyro.
inline const Effect gyroBias{
    .id = "gyro_bias",
    .unit = "rad/s",
    .sites = {Site::imu},
    .hasAxis = true,
    .lower = -0.5,
    .upper = 0.5,
    .starts = {-0.02, 0.02},
    .linear = true,
    .sentence = "The gyro shows a turn at rest.",
    .exposedBy = "any, standing still too",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { plant.imu.gyroBias += value * unitVector(place.axis); },
};

}  // namespace plumbline::gap
