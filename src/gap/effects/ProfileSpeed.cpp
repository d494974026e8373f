#include "gap/effects/Effect.h"

namespace plumbline::gap {

inline constexpr double noProfile = 100;  // [rad/s]: faster than any servo

/// The servo moves the goal that it follows at this speed at most, whatever it is commanded.
const Effect profileSpeed{
    .id = "profile_speed",
    .order = 440,
    .unit = "rad/s",
    .sites = {Site::joint},
    .nominal = noProfile,
    .lower = 0.05,
    .upper = noProfile,
    .starts = {1, 3, 8},
    .reciprocal = true,
    .ofServo = true,
    .setting = true,
    .sentence = "The servo of {at} smooths its commands: it moves its own goal at a limited speed.",
    .exposedBy = "steps and fast moves",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          atJoints(plant, place,
                   [value](JointPlant& joint) { joint.profileSpeed = value < noProfile ? value : 0; });
        },
    .inWalk = true,
    .nominalIsNone = true,
    .drawing = {.where = DrawRange::Where::joint, .low = 0.8, .high = 3, .growth = DrawRange::Growth::limit},
};
MAKE_EFFECT(profileSpeed);

}  // namespace plumbline::gap
