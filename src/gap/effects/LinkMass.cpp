#include <algorithm>
#include <stdexcept>

#include "gap/effects/Sizes.h"

namespace plumbline::gap {

namespace {

constexpr double leastMass = 5e-3;  ///< that is left when some is taken out [kg]

}  // namespace

/// Mass added to a link.
const Effect linkMass{
    .id = "link_mass",
    .order = 210,
    .unit = "kg",
    .sites = {Site::link},
    .lower = -0.4,
    .upper = 1.5,
    .starts = {-0.05, 0.1, 0.4},
    .linear = true,
    .belowShare = 0.2,  // things are put on robots more often than taken off
    .variants = {"a load at the centre of mass", "spread over the link"},
    .sentence = "{at} is heavier or lighter than the model's.",
    .exposedBy = "static poses, slow motions",
    .scale = scaleOfMass,
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          auto& link = plant.mechanism.links[static_cast<std::size_t>(place.index)];
          const double factor = variant == 1 ? std::max(0.05, (link.mass + value) / link.mass) : 1;
          link.mass = std::max(1e-3, link.mass + value);
          link.inertia *= factor;
        },
    .inWalk = true,
    .alike = {"com_offset", 11},
    .drawing = {.where = DrawRange::Where::link, .low = 0.08, .high = 0.3},
    .planting = {.rank = 4,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       double& mass = data.robot.links[static_cast<std::size_t>(place.index)].mass;
                       mass -= value;
                       if (mass < leastMass) throw std::runtime_error("no mass would be left");
                     }},
};
MAKE_EFFECT(linkMass);

}  // namespace plumbline::gap
