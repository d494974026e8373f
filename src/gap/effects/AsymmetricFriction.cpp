#include <array>
#include <cmath>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

inline constexpr std::array<double, 2> otherWay{0, 0.5};  // share of the friction that is there both ways

/// Dry friction that is stronger one way: a positive value against positive motion, a negative one against
/// negative motion. At a joint with a servo it acts as Coulomb friction of the mean and a constant torque do
/// together.
const Effect asymmetricFriction{
    .id = "asymmetric_friction",
    .order = 400,
    .unit = "N m",
    .sites = {Site::joint},
    .lower = -0.5,
    .upper = 0.5,
    .starts = {-0.1, 0.1},
    .sticks = true,
    .variants = {"none the other way", "half as much the other way"},
    .sentence = "Dry friction holds {at} back more in one direction than in the other.",
    .exposedBy = "slow reversals, small motions",
    .scale = [](const Mechanism& m,
                const Place& p) { return m.joints[static_cast<std::size_t>(p.index)].maxTorque; },
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          const double weaker = otherWay[static_cast<std::size_t>(variant)] * std::abs(value);
          atJoints(plant, place, [value, weaker](JointPlant& joint) {
            joint.coulombForward += value > 0 ? value : weaker;
            joint.coulombBackward += value < 0 ? -value : weaker;
          });
        },
    .inWalk = true,
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.06,
                .high = 0.15,
                .unit = DrawRange::Unit::torque,
                .bothSigns = true},
};
MAKE_EFFECT(asymmetricFriction);

}  // namespace plumbline::gap
