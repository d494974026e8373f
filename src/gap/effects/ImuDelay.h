#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Age of an inertial reading when it is reported.
inline const Effect imuDelay{
    .id = "imu_delay",
    .unit = "s",
    .sites = {Site::imu},
    .lower = 0,
    .upper = 0.1,
    .starts = {0.01, 0.03},
    .linear = true,
    .sentence = "Readings of the inertial sensor are late.",
    .exposedBy = "motions of the torso",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          plant.imu.delay += value;
          (void)place;
        },
};

}  // namespace plumbline::gap
