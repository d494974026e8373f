#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// Friction at rest that grows with the square of the torque through the gear, the smaller one of the
/// motor's and the link's: what model M6 of BAM adds (Duclusaud et al. 2024). It falls off within 0.1 rad/s.
const Effect quadraticLoadFriction{
    .id = "quadratic_load_friction",
    .order = 430,
    .unit = "1/(N m)",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 2,
    .starts = {0.3, 1},
    .sticks = true,
    .ofServo = true,
    .variants = {"whichever drives", "while the motor drives", "while the load drives"},
    .sentence = "Friction of {at} grows with the square of the load that the gear transmits.",
    .exposedBy = "slow reversals under large loads",
    .scale = [](const Mechanism& m, const Place& p) { return 1 / std::max(1e-3, jointOf(m, p).maxTorque); },
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.quadraticLoadFriction += value;
            joint.quadraticFlow = static_cast<JointPlant::Flow>(variant);
          });
        },
    .inWalk = true,
    .screening = {.underLoad = Screening::UnderLoad::weakMotor},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.3, .high = 1, .unit = DrawRange::Unit::perTorque},
};
MAKE_EFFECT(quadraticLoadFriction);

}  // namespace plumbline::gap
