#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on the distance from a link's own joint to what it carries.
const Effect linkLength{
    .id = "link_length",
    .order = 230,
    .unit = "1",
    .sites = {Site::link},
    .nominal = 1,
    .lower = 0.6,
    .upper = 1.6,
    .starts = {0.9, 1.1},
    .linear = true,
    .variants = {"its centre of mass moves along", "its centre of mass stays"},
    .sentence = "{at} is longer or shorter than the model's.",
    .exposedBy = "static poses, slow motions",
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          auto& link = plant.mechanism.links[static_cast<std::size_t>(place.index)];
          for (auto& joint : plant.mechanism.joints)
            if (joint.parent == place.index) joint.origin *= value;
          for (auto& foot : plant.mechanism.feet)
            if (foot.link == place.index) foot.soleCentre.z() *= value;
          if (variant == 0) link.com *= value;
        },
    .inWalk = true,
    .drawing = {.where = DrawRange::Where::link,
                .low = 0.8,
                .high = 0.92,
                .low2 = 1.08,
                .high2 = 1.2,
                .growth = DrawRange::Growth::factor},
    .planting = {.rank = 6,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       data.robot.links[static_cast<std::size_t>(place.index)].com /= value;
                       for (Mechanism::Joint& joint : data.robot.joints)
                         if (joint.parent == place.index) joint.origin /= value;
                       for (Mechanism::Foot& foot : data.robot.feet)
                         if (foot.link == place.index) foot.soleCentre.z() /= value;
                     }},
};
MAKE_EFFECT(linkLength);

}  // namespace plumbline::gap
