#include <algorithm>

#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// Added to the rotor's inertia seen at the joint.
const Effect rotorInertia{
    .id = "rotor_inertia",
    .order = 180,
    .unit = "kg m^2",
    .sites = {Site::joint},
    .lower = -0.005,
    .upper = 0.08,
    .starts = {0.003, 0.015},
    .linear = true,
    .ofServo = true,
    .sentence = "The rotor of {at} is heavier than the model's.",
    .exposedBy = "chirps and steps",
    .scale = scaleOfRotor,
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          atJoints(plant, place, [value](JointPlant& joint) {
            joint.servo.armature = std::max(1e-5, joint.servo.armature + value);
          });
        },
    .inWalk = true,
    .suspect = 6,
    .alike = {"load_friction", 16},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.006, .high = 0.03},
    .perJointFit = {.rank = 10},
};
MAKE_EFFECT(rotorInertia);

}  // namespace plumbline::gap
