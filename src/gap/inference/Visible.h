#pragma once
#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// Whether a set's i-th cause changes the replay, with the values of the others kept: in some cell by a root
/// mean square above enginesDiffer.
bool isVisible(const Replayer& replayer, const Explanation& causes, std::size_t i);

}  // namespace plumbline::gap
