#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Position error that the servo does not act on.
const Effect deadBand{
    .id = "dead_band",
    .order = 140,
    .unit = "rad",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.1,
    .starts = {0.004, 0.015, 0.04},
    .sticks = true,
    .ofServo = true,
    .setting = true,
    .variants = {"what exceeds the band counts", "beyond the band the whole error counts"},
    .sentence = "The servo of {at} ignores small errors.",
    .exposedBy = "slow motions and static poses",
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.deadBand += value;
            joint.deadBandSteps = variant == 1;
          });
        },
    .inWalk = true,
    .alike = {"backlash", 8},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.005, .high = 0.02},
};
MAKE_EFFECT(deadBand);

}  // namespace plumbline::gap
