#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Dry friction in proportion to the torque that goes through the gear.
const Effect loadFriction{
    .id = "load_friction",
    .order = 100,
    .unit = "1",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.9,
    .starts = {0.05, 0.15, 0.35},
    .sticks = true,
    .ofServo = true,
    .variants = {"load as the motor's torque less what turns the rotor", "load as what reaches the link",
                 "load as the motor's torque"},
    .sentence = "Friction of {at} grows with the load that the gear transmits.",
    .exposedBy = "slow reversals under load",
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.loadFriction += value;
            joint.loadIs = static_cast<JointPlant::Load>(variant);
          });
        },
    .inWalk = true,
    .alike = {"rotor_inertia", 15},
    .screening = {.underLoad = Screening::UnderLoad::weakMotor},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.15, .high = 0.4},
    // Friction grows with what the gear transmits to the link, as in Duclusaud et al. 2024.
    .perJointFit = {.rank = 50, .variant = static_cast<int>(JointPlant::Load::linkTorque)},
};
MAKE_EFFECT(loadFriction);

}  // namespace plumbline::gap
