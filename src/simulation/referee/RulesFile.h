#pragma once
#include <string>

#include "simulation/referee/Rules.h"

namespace plumbline::simulation {

/// The rules of a file like doc/reference/rules.yaml: what it does not name keeps its value here. Throws
/// ConfigurationError, one line with file, line and key, for what cannot be, and for a key there is not.
Rules readRules(const std::string& path, const Rules& fallback = {});

/// A file with all that can be set, as it is set in these rules: doc/reference/rules.yaml is that of the
/// league's.
std::string rulesText(const Rules& rules = {});

}  // namespace plumbline::simulation
