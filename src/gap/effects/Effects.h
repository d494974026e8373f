#pragma once
#include <string_view>
#include <vector>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// The library: every effect linked into the program, sorted by Effect::order. Complete once main runs.
const std::vector<const Effect*>& effects();

/// What system identification fits in every joint (Effect::perJointFit), in the order of the fit.
std::vector<const Effect*> actuatorEffects();

/// Effects with this order or a larger one are not in the project's original list.
inline constexpr int beyondContract = 400;

/// The effect with an id; null if the library has none.
const Effect* findEffect(std::string_view id);

/// Whether the effect can be at a joint.
bool sitsAtJoints(const Effect& effect);

/// All places where an effect can sit on a robot, axes included. For a robot with one motor, "all joints" is
/// not an additional place.
std::vector<Place> placesOf(const Effect& effect, const Mechanism& mechanism);

/// The place of that name and axis ("" or "x", "y", "z"). Throws std::invalid_argument in one line that names
/// what there is.
Place findPlace(const Effect& effect, const Mechanism& mechanism, std::string_view at, std::string_view axis);

}  // namespace plumbline::gap
