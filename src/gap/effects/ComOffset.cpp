#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// Shift of a link's centre of mass.
const Effect comOffset{
    .id = "com_offset",
    .order = 220,
    .unit = "m",
    .sites = {Site::link},
    .hasAxis = true,
    .lower = -0.06,
    .upper = 0.06,
    .starts = {-0.01, 0.01},
    .linear = true,
    .sentence = "The centre of mass of {at} is elsewhere than the model's.",
    .exposedBy = "static poses, slow motions",
    .scale = scaleOfLength,
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          auto& link = plant.mechanism.links[static_cast<std::size_t>(place.index)];
          link.com += value * unitVector(place.axis);
        },
    .inWalk = true,
    .alike = {"link_mass", 12},
    .drawing =
        {.where = DrawRange::Where::link, .low = 0.015, .high = 0.04, .bothSigns = true, .axes = "xyz"},
    .planting = {.rank = 5,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       data.robot.links[static_cast<std::size_t>(place.index)].com -=
                           value * unitVector(place.axis);
                     }},
};
MAKE_EFFECT(comOffset);

}  // namespace plumbline::gap
