#pragma once
#include <string>
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Whether commands look as if they moved linearly between the cycles of a log though each is taken as held.
/// Those of a controller that is faster than its log do. Then the nominal model leaves at most half of the
/// squares of positions. A hint for people; empty: they do not, or no recording is of that kind.
std::string holdHint(const std::vector<Trial>& trials);

}  // namespace plumbline::gap
