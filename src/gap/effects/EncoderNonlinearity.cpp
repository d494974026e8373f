#include <array>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

constexpr std::array<double, 2> encoderPhases{0, 1.5707963267948966};

/// Measured angle = true + value sin(true + phase).
const Effect encoderNonlinearity{
    .id = "encoder_nonlinearity",
    .order = 200,
    .unit = "rad",
    .sites = {Site::joint},
    .lower = -0.15,
    .upper = 0.15,
    .starts = {-0.02, 0.02},
    .linear = true,
    .variants = {"sine", "cosine"},
    .sentence = "The encoder of {at} is not round: its error repeats once a turn.",
    .exposedBy = "slow wide sweeps",
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.encoderAmplitude = value;
            joint.encoderPhase = encoderPhases[static_cast<std::size_t>(variant)];
          });
        },
    .inWalk = true,
    .screening = {.inNeighbours = true},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.02, .high = 0.06, .bothSigns = true},
};
MAKE_EFFECT(encoderNonlinearity);

}  // namespace plumbline::gap
