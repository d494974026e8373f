#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on the proportional gain.
const Effect servoGain{
    .id = "servo_gain",
    .order = 30,
    .unit = "1",
    .sites = {Site::joint},
    .nominal = 1,
    .lower = 0.2,
    .upper = 2.5,
    .starts = {0.8, 1.25},
    .linear = true,
    .ofServo = true,
    .sentence = "The servo of {at} is softer or stiffer than the model's.",
    .exposedBy = "static poses under different loads, slow motions",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          atJoints(plant, place, [value](JointPlant& joint) {
            joint.servo.kp *= value;
            joint.servo.kpFirmware *= value;
          });
        },
    .inWalk = true,
    .suspect = 1,
    .alike = {"joint_compliance", 3},
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.6,
                .high = 0.85,
                .low2 = 1.2,
                .high2 = 1.5,
                .growth = DrawRange::Growth::factor},
    .perJointFit = {.rank = 60},
    .planting = {.rank = 1,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       changeServo(
                           data, place,
                           [value](Mechanism::Joint& joint) {
                             joint.servo.kp /= value;
                             joint.servo.kpFirmware /= value;
                           },
                           [value](ServoOverride& servo) {
                             divide(servo.kp, value);
                             divide(servo.kpFirmware, value);
                           });
                     }},
};
MAKE_EFFECT(servoGain);

}  // namespace plumbline::gap
