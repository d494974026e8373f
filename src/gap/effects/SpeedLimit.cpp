#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// Factor on the speed at which the torque has faded to nothing.
const Effect speedLimit{
    .id = "speed_limit",
    .order = 60,
    .unit = "1",
    .sites = {Site::joint, Site::everywhere},
    .nominal = 1,
    .lower = 0.05,
    .upper = 1.5,
    .starts = {0.2, 0.4, 0.7},
    .reciprocal = true,
    .setting = true,
    .sentence = "{at} does not reach the speed that the model allows.",
    .exposedBy = "fast moves near the speed limit",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.maxSpeed *= value; }); },
    .inWalk = true,
    .canBeAt =
        [](const Mechanism& m, const Place& p) {
          // A DC motor's law has no such limit.
          return jointOf(m, p).servo.model != Servo::Model::dcMotor;
        },
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.1,
                .high = 0.35,
                .growth = DrawRange::Growth::factor},
    .planting = {.rank = 10,
                 .possible = hasLinearServo,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       changeServo(
                           data, place, [value](Mechanism::Joint& joint) { joint.maxSpeed /= value; },
                           [value](ServoOverride& servo) { divide(servo.maxSpeed, value); });
                     }},
};
MAKE_EFFECT(speedLimit);

}  // namespace plumbline::gap
