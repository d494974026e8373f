#include <algorithm>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Friction proportional to speed, on top of whatever the servo does.
const Effect viscousFriction{
    .id = "viscous_friction",
    .order = 80,
    .unit = "N m s/rad",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 3,
    .starts = {0.1, 0.5},
    .linear = true,
    .ofServo = true,
    .sentence = "Friction that grows with speed holds {at} back.",
    .exposedBy = "chirps and fast moves",
    .scale =
        [](const Mechanism& m, const Place& p) {
          const Mechanism::Joint& joint = m.joints[static_cast<std::size_t>(p.index)];
          return std::max(0.05, joint.servo.kd + joint.damping);
        },
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.viscous += value; }); },
    .inWalk = true,
    .suspect = 3,
    .alike = {"servo_damping", 5},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.3, .high = 1, .unit = DrawRange::Unit::damping},
    .perJointFit = {.rank = 20},
};
MAKE_EFFECT(viscousFriction);

}  // namespace plumbline::gap
