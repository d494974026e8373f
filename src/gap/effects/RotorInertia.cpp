#include <algorithm>
#include <stdexcept>

#include "gap/effects/Sizes.h"

namespace plumbline::gap {

namespace {

constexpr double leastRotor = 2e-5;  ///< that is left when some is taken out [kg m^2]

}  // namespace

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
    .planting = {.rank = 3,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       const auto take = [value](double& armature) {
                         armature -= value;
                         if (armature < leastRotor) throw std::runtime_error("no rotor would be left");
                       };
                       changeServo(
                           data, place, [&](Mechanism::Joint& joint) { take(joint.servo.armature); },
                           [&](ServoOverride& servo) {
                             if (servo.armature) take(*servo.armature);
                           });
                     }},
};
MAKE_EFFECT(rotorInertia);

}  // namespace plumbline::gap
