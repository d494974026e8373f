#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Rotation of the ground about an axis of the world, x or y.
const Effect groundSlope{
    .id = "ground_slope",
    .order = 290,
    .unit = "rad",
    .sites = {Site::ground},
    .hasAxis = true,
    .lower = -0.15,
    .upper = 0.15,
    .starts = {-0.02, 0.02},
    .linear = true,
    .variants = {"put down level with the ground", "put down upright"},
    .sentence = "The ground is not level.",
    .exposedBy = "the same stance with two headings",
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          plant.ground.slope += value * unitVector(place.axis);
          plant.ground.putUpright = variant == 1;
        },
    .inWalk = true,
    .drawing = {.where = DrawRange::Where::ground,
                .low = 0.02,
                .high = 0.08,
                .bothSigns = true,
                .axes = "xy",
                .floatingBase = true},
};
MAKE_EFFECT(groundSlope);

}  // namespace plumbline::gap
