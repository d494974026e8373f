#include <array>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

inline constexpr std::array<double, 3> stribeckSpeeds{0.1, 0.03, 0.3};  // [rad/s]

/// Extra friction at rest that falls off as exp(-(speed / v)^2) (Armstrong-Helouvry 1994).
const Effect stribeckFriction{
    .id = "stribeck_friction",
    .order = 90,
    .unit = "N m",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.5,
    .starts = {0.03, 0.1, 0.25},
    .sticks = true,
    .ofServo = true,
    .variants = {"falls within 0.1 rad/s", "falls within 0.03 rad/s", "falls within 0.3 rad/s"},
    .sentence = "{at} sticks: friction at rest is larger than in motion.",
    .exposedBy = "slow reversals, starts from rest",
    .scale = [](const Mechanism& m,
                const Place& p) { return m.joints[static_cast<std::size_t>(p.index)].maxTorque; },
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.stribeck += value;
            joint.stribeckSpeed = stribeckSpeeds[static_cast<std::size_t>(variant)];
          });
        },
    .inWalk = true,
    .alike = {"coulomb_friction", 2},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.05, .high = 0.15, .unit = DrawRange::Unit::torque},
    .perJointFit = {.rank = 40},
};
MAKE_EFFECT(stribeckFriction);

}  // namespace plumbline::gap
