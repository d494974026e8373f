#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// A spring between motor and link.
const Effect jointCompliance{
    .id = "joint_compliance",
    .order = 120,
    .unit = "rad/(N m)",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.5,
    .starts = {0.005, 0.02, 0.06, 0.2},
    .ofServo = true,
    .variants = {"encoder where the model has it", "encoder on the other side of the gear"},
    .sentence = "The gear of {at} twists under torque.",
    .exposedBy = "static poses under different loads, chirps",
    .scale = scaleOfCompliance,
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.compliance += value;
            if (variant == 1) joint.linkEncoder = !joint.linkEncoder;
          });
        },
    .inWalk = true,
    .suspect = 5,
    .alike = {"servo_gain", 4},
    .screening = {.behindGear = true, .underLoad = Screening::UnderLoad::weakMotor},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.02, .high = 0.08},
};
MAKE_EFFECT(jointCompliance);

}  // namespace plumbline::gap
