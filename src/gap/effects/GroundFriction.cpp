#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Coefficient of Coulomb friction between sole and ground.
const Effect groundFriction{
    .id = "ground_friction",
    .order = 280,
    .unit = "1",
    .sites = {Site::ground},
    .nominal = 0.8,
    .lower = 0.02,
    .upper = 1.5,
    .starts = {0.1, 0.3, 0.5},
    .engineShare = 0.15,
    .sentence = "The ground is more slippery or rougher than the model's.",
    .exposedBy = "feet pressed apart and twisted against the ground",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          plant.ground.friction = value;
          (void)place;
        },
    .inWalk = true,
    .drawing = {.where = DrawRange::Where::ground,
                .low = 0.1,
                .high = 0.3,
                .growth = DrawRange::Growth::factor,
                .floatingBase = true},
};
MAKE_EFFECT(groundFriction);

}  // namespace plumbline::gap
