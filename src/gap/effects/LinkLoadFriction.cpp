#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Dry friction proportional to the torque on the link's side of the gear, in addition to that on the motor's
/// side (load_friction). With both, driving and being driven differ, as in model M5 of BAM (Duclusaud et al.
/// 2024). For recordings and simulations: alone it is load_friction in its second form, which a diagnosis
/// looks for already.
const Effect linkLoadFriction{
    .id = "link_load_friction",
    .order = 420,
    .unit = "1",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.9,
    .starts = {0.1, 0.35},
    .sticks = true,
    .ofServo = true,
    .sentence = "Friction of {at} grows with the torque on its link, whatever the motor does.",
    .exposedBy = "slow reversals under load, being moved by the load",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          atJoints(plant, place, [value](JointPlant& joint) { joint.linkLoadFriction += value; });
        },
    .inWalk = true,
    .canBeAt = [](const Mechanism&, const Place&) { return false; },
};
MAKE_EFFECT(linkLoadFriction);

}  // namespace plumbline::gap
