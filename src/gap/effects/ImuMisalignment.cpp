#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Rotation of the sensor about the torso's axis.
const Effect imuMisalignment{
    .id = "imu_misalignment",
    .order = 240,
    .unit = "rad",
    .sites = {Site::imu},
    .hasAxis = true,
    .lower = -0.5,
    .upper = 0.5,
    .starts = {-0.03, 0.03},
    .linear = true,
    .sentence = "The inertial sensor is turned against the torso.",
    .exposedBy = "any, standing still too",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          plant.imu.R_true_sensor =
              Eigen::AngleAxisd(value, unitVector(place.axis)) * plant.imu.R_true_sensor;
        },
    .drawing = {.where = DrawRange::Where::imu, .low = 0.03, .high = 0.1, .bothSigns = true, .axes = "xy"},
};
MAKE_EFFECT(imuMisalignment);

}  // namespace plumbline::gap
