#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Constant error of the gyro.
const Effect gyroBias{
    .id = "gyro_bias",
    .order = 250,
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
    .drawing = {.where = DrawRange::Where::imu, .low = 0.02, .high = 0.1, .bothSigns = true, .axes = "xyz"},
};
MAKE_EFFECT(gyroBias);

}  // namespace plumbline::gap
