#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on a foot's force sensors.
const Effect fsrGain{
    .id = "fsr_gain",
    .order = 270,
    .unit = "1",
    .sites = {Site::foot},
    .nominal = 1,
    .lower = 0.1,
    .upper = 3,
    .starts = {0.8, 1.2},
    .linear = true,
    .sentence = "The force sensors of {at} show too much or too little.",
    .exposedBy = "standing, weight shifts",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { plant.footGain[static_cast<std::size_t>(place.index)] *= value; },
    .drawing = {.where = DrawRange::Where::foot,
                .low = 0.7,
                .high = 0.9,
                .low2 = 1.1,
                .high2 = 1.3,
                .growth = DrawRange::Growth::factor,
                .floatingBase = true},
};
MAKE_EFFECT(fsrGain);

}  // namespace plumbline::gap
