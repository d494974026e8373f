#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on the derivative gain; unlike viscous friction it lies within the torque limit.
const Effect servoDamping{
    .id = "servo_damping",
    .order = 40,
    .unit = "1",
    .sites = {Site::joint},
    .nominal = 1,
    .lower = 0,
    .upper = 4,
    .starts = {0.5, 2},
    .linear = true,
    .ofServo = true,
    .sentence = "The servo of {at} brakes its own motion more or less than the model's.",
    .exposedBy = "chirps and fast moves",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          atJoints(plant, place, [value](JointPlant& joint) {
            const double change = joint.servo.kd * (value - 1);
            joint.servo.kd += change;
            joint.extraDamping += change;
          });
        },
    .inWalk = true,
    .alike = {"viscous_friction", 6},
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.3,
                .high = 0.7,
                .low2 = 1.4,
                .high2 = 2.5,
                .growth = DrawRange::Growth::factor},
    .perJointFit = {.rank = 70},
    .planting = {.rank = 2,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       changeServo(
                           data, place,
                           [value](Mechanism::Joint& joint) {
                             joint.servo.kd /= value;
                             // Of a DC motor: push kt / R stays, the back EMF's kt^2 / R shrinks.
                             joint.servo.kt /= value;
                             joint.servo.R /= value;
                           },
                           [value](ServoOverride& servo) { divide(servo.kd, value); });
                     }},
};
MAKE_EFFECT(servoDamping);

}  // namespace plumbline::gap
