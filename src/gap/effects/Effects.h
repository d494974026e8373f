#pragma once
#include <string_view>
#include <vector>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// The library: every effect linked into the program, the contract's in its order. Complete once main runs.
const std::vector<const Effect*>& effects();

/// Effect::order from which on effects are not the contract's.
inline constexpr int beyondContract = 400;

/// By id; null where the library has none of that name.
const Effect* findEffect(std::string_view id);

/// Whether one of its places is a joint.
bool sitsAtJoints(const Effect& effect);

/// All places where an effect can sit on a robot, axes included. All joints of a robot with one motor are no
/// place besides that one.
std::vector<Place> placesOf(const Effect& effect, const Mechanism& mechanism);

/// The place of that name and axis ("" or "x", "y", "z"). Throws std::invalid_argument in one line that names
/// what there is.
Place findPlace(const Effect& effect, const Mechanism& mechanism, std::string_view at, std::string_view axis);

}  // namespace plumbline::gap
