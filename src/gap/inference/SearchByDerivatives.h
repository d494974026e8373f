#pragma once
#include "gap/inference/SetSearch.h"

namespace plumbline::gap {

/// Searches for the set of causes with the best score among many kinds. Few causes are fitted set by set. If
/// that ends at the limit of causes, derivatives propose larger sets, and the best of them is climbed. Where
/// something remains unexplained, derivatives are taken again from there, without and with settings that
/// were not in force in each recording (proposedSettings).
BeamResult searchByDerivatives(const SearchTools& tools, const SetSearchOptions& options);

}  // namespace plumbline::gap
