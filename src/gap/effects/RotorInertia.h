#pragma once
#include <algorithm>

#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// Added to the rotor's inertia seen at the joint.
inline const Effect rotorInertia{
    .id = "rotor_inertia",
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
};

}  // namespace plumbline::gap
