#pragma once
#include <string>

#include "situation/Situation.h"

namespace plumbline {

/// A situation in YAML (doc/reference/situation-files.md). Throws ConfigurationError, one line with file,
/// line and key, for what is missing, cannot be or is no key of this decider; then with the nearest name.
Situation readSituation(const std::string& path);

/// The same as text; what it holds reads back as the same situation, numbers with two decimals.
std::string situationText(const Situation& situation);

}  // namespace plumbline
