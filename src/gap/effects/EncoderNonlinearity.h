#pragma once
#include <array>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

inline constexpr std::array<double, 2> encoderPhases{0, 1.5707963267948966};

/// Measured angle = true + value sin(true + phase).
inline const Effect encoderNonlinearity{
    .id = "encoder_nonlinearity",
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
};

}  // namespace plumbline::gap
