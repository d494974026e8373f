#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on the voltage that torque and speed limits come from.
const Effect supplyVoltage{
    .id = "supply_voltage",
    .order = 150,
    .unit = "1",
    .sites = {Site::everywhere},
    .nominal = 1,
    .lower = 0.2,
    .upper = 1.5,
    .starts = {0.4, 0.6, 0.85},
    .reciprocal = true,
    .sentence = "The supply is weaker than the model's: torque and speed limits shrink together.",
    .exposedBy = "fast moves at the limits",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          atJoints(plant, place, [value](JointPlant& joint) {
            // A DC motor's law has the voltage in it, and no limit but what that drives through the winding.
            if (joint.servo.model == Servo::Model::dcMotor) {
              joint.supplyFactor *= value;
              return;
            }
            joint.torqueFactor *= value;
            joint.maxSpeed *= value;
          });
        },
    .inWalk = true,
    .drawing = {.where = DrawRange::Where::all,
                .low = 0.12,
                .high = 0.3,
                .growth = DrawRange::Growth::factor},
};
MAKE_EFFECT(supplyVoltage);

}  // namespace plumbline::gap
