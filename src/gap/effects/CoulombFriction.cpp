#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Dry friction, independent of speed and load.
const Effect coulombFriction{
    .id = "coulomb_friction",
    .order = 70,
    .unit = "N m",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.5,
    .starts = {0.02, 0.08, 0.2},
    .sticks = true,
    .ofServo = true,
    .sentence = "Dry friction holds {at} back.",
    .exposedBy = "slow reversals, small motions",
    .scale = [](const Mechanism& m,
                const Place& p) { return m.joints[static_cast<std::size_t>(p.index)].maxTorque; },
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.coulomb += value; }); },
    .inWalk = true,
    .suspect = 2,
    .alike = {"stribeck_friction", 1},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.03, .high = 0.12, .unit = DrawRange::Unit::torque},
    .perJointFit = {.rank = 30},
};
MAKE_EFFECT(coulombFriction);

}  // namespace plumbline::gap
