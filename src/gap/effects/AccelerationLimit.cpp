#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// The servo's own profile towards a new command.
const Effect accelerationLimit{
    .id = "acceleration_limit",
    .order = 130,
    .unit = "rad/s^2",
    .sites = {Site::joint},
    .nominal = 4000,  // none: a servo that follows within a cycle of 10 ms
    .lower = 1,
    .upper = 4000,
    .starts = {10, 30, 80, 250},
    .reciprocal = true,
    .ofServo = true,
    .setting = true,
    .sentence = "The servo of {at} smooths its commands: it keeps an acceleration limit.",
    .exposedBy = "steps and fast moves",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          atJoints(plant, place, [value](JointPlant& joint) { joint.accelerationLimit = value; });
        },
    .inWalk = true,
    .nominalIsNone = true,
    .drawing = {.where = DrawRange::Where::joint, .low = 10, .high = 40, .growth = DrawRange::Growth::limit},
};
MAKE_EFFECT(accelerationLimit);

}  // namespace plumbline::gap
