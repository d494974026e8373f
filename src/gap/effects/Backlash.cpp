#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Whole play between motor and link; motor and link turn apart within it.
const Effect backlash{
    .id = "backlash",
    .order = 110,
    .unit = "rad",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.4,
    .starts = {0.01, 0.03, 0.08, 0.17},
    .ofServo = true,
    .variants = {"encoder where the model has it", "encoder on the other side of the gear"},
    .sentence = "The gear of {at} has play.",
    .exposedBy = "small reversals across the sign of gravity",
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.backlash += value;
            if (variant == 1) joint.linkEncoder = !joint.linkEncoder;
          });
        },
    .inWalk = true,
    .suspect = 4,
    .alike = {"dead_band", 7},
    .screening = {.behindGear = true},
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.02,
                .high = 0.08,
                .choice = {"side", "motor", "link"}},
};
MAKE_EFFECT(backlash);

}  // namespace plumbline::gap
