#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// Force on a link's centre of mass, fixed in the world.
const Effect externalForce{
    .id = "external_force",
    .order = 310,
    .unit = "N",
    .sites = {Site::link},
    .hasAxis = true,
    .lower = -15,
    .upper = 15,
    .starts = {-2, 2},
    .linear = true,
    .sentence = "Something pulls at {at}: a cable, a hand.",
    .exposedBy = "static poses with two headings",
    .scale = scaleOfMass,
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          plant.forces.push_back({place.index, value * unitVector(place.axis)});
        },
    .drawing = {.where = DrawRange::Where::link,
                .low = 1.5,
                .high = 6,
                .bothSigns = true,
                .axes = "xyz",
                .floatingBase = true},
};
MAKE_EFFECT(externalForce);

}  // namespace plumbline::gap
