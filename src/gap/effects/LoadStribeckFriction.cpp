#include <array>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

inline constexpr std::array<double, 2> loadStribeckSpeeds{0.1, 0.3};  // [rad/s]

/// Load friction at rest over that in motion, which falls off as exp(-(speed / v)^2): what model M4 of BAM
/// has besides load friction and Stribeck's (Duclusaud et al. 2024).
const Effect loadStribeckFriction{
    .id = "load_stribeck_friction",
    .order = 410,
    .unit = "1",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.9,
    .starts = {0.1, 0.4},
    .sticks = true,
    .ofServo = true,
    .variants = {"falls within 0.1 rad/s", "falls within 0.3 rad/s"},
    .sentence = "{at} sticks under load: the more the gear transmits, the more it holds at rest.",
    .exposedBy = "slow reversals under load, starts from rest",
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.loadStribeck += value;
            joint.loadStribeckSpeed = loadStribeckSpeeds[static_cast<std::size_t>(variant)];
          });
        },
    .inWalk = true,
    .screening = {.underLoad = Screening::UnderLoad::weakMotor},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.2, .high = 0.5},
};
MAKE_EFFECT(loadStribeckFriction);

}  // namespace plumbline::gap
