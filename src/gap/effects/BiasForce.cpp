#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// A spring, a cable or a wrong zero of torque.
const Effect biasForce{
    .id = "bias_force",
    .order = 160,
    .unit = "N m",
    .sites = {Site::joint},
    .lower = -0.6,
    .upper = 0.6,
    .starts = {-0.1, 0.1},
    .linear = true,
    .sentence = "A constant torque pulls at {at}.",
    .exposedBy = "static poses",
    .scale = [](const Mechanism& m,
                const Place& p) { return m.joints[static_cast<std::size_t>(p.index)].maxTorque; },
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.biasForce += value; }); },
    .inWalk = true,
    .alike = {"joint_offset", 14},
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.04,
                .high = 0.12,
                .unit = DrawRange::Unit::torque,
                .bothSigns = true},
    .perJointFit = {.rank = 100},
};
MAKE_EFFECT(biasForce);

}  // namespace plumbline::gap
