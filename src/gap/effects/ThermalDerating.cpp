#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// Loss of torque limit per joule; the heat is the integral of torque^2 * 1 s/(kg m^2), or of |torque *
/// speed|.
const Effect thermalDerating{
    .id = "thermal_derating",
    .order = 170,
    .unit = "1/J",
    .sites = {Site::joint, Site::everywhere},
    .lower = 0,
    .upper = 0.5,
    .starts = {0.0005, 0.003, 0.02, 0.07, 0.2},  // a limit that is just reached shows at no other
    .setsIn = true,
    .variants = {"heat as the integral of torque squared", "heat as the integral of mechanical power"},
    .sentence = "The motor of {at} loses torque as it warms up.",
    .exposedBy = "long fast moves at the torque limit",
    .scale = scalePerHeat,
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.deratingPerJoule += value;
            joint.heatIsWork = variant == 1;
          });
        },
    .inWalk = true,
    .alike = {"torque_limit", 10},
    .screening = {.underLoad = Screening::UnderLoad::weakMotor},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.005, .high = 0.02},
};
MAKE_EFFECT(thermalDerating);

}  // namespace plumbline::gap
