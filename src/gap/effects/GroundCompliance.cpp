#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Of each corner of a sole; a lawn or a carpet.
const Effect groundCompliance{
    .id = "ground_compliance",
    .order = 300,
    .unit = "m/N",
    .sites = {Site::ground},
    .nominal = 2e-06,
    .lower = 1e-06,
    .upper = 0.002,
    .starts = {3e-05, 0.0001, 0.0004},
    .sentence = "The ground is soft under the feet.",
    .exposedBy = "squats, weight shifts",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          plant.ground.compliance = value;
          (void)place;
        },
    .inWalk = true,
    .drawing = {.where = DrawRange::Where::ground, .low = 3e-5, .high = 3e-4, .floatingBase = true},
};
MAKE_EFFECT(groundCompliance);

}  // namespace plumbline::gap
