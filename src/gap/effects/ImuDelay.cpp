#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Age of an inertial reading when it is reported.
const Effect imuDelay{
    .id = "imu_delay",
    .order = 260,
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
    .drawing = {.where = DrawRange::Where::imu, .low = 0.01, .high = 0.04, .floatingBase = true},
};
MAKE_EFFECT(imuDelay);

}  // namespace plumbline::gap
