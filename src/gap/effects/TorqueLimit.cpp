#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on the largest torque.
const Effect torqueLimit{
    .id = "torque_limit",
    .order = 50,
    .unit = "1",
    .sites = {Site::joint, Site::everywhere},
    .nominal = 1,
    .lower = 0.03,
    .upper = 1.5,
    .starts = {0.15, 0.4, 0.7},
    .reciprocal = true,
    .setting = true,
    .sentence = "The motor of {at} gives less torque than the model's.",
    .exposedBy = "fast moves at the torque limit",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.torqueFactor *= value; }); },
    .inWalk = true,
    .alike = {"thermal_derating", 9},
    .screening = {.underLoad = Screening::UnderLoad::weakMotor},
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.1,
                .high = 0.3,
                .growth = DrawRange::Growth::factor},
    .perJointFit = {.rank = 80},
    .planting = {.rank = 9,
                 .possible = hasLinearServo,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       changeServo(
                           data, place, [value](Mechanism::Joint& joint) { joint.maxTorque /= value; },
                           [value](ServoOverride& servo) { divide(servo.maxTorque, value); });
                     }},
};
MAKE_EFFECT(torqueLimit);

}  // namespace plumbline::gap
