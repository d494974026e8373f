#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on the proportional gain.
inline const Effect servoGain{
    .id = "servo_gain",
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
};

}  // namespace plumbline::gap
