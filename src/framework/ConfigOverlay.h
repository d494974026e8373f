#pragma once
#include "framework/ConfigNode.h"

namespace plumbline {

/// Overrides a file of an earlier config directory by that of a later one: maps are merged key by key,
/// anything else is replaced. A line that was lost from the later file would silently give the earlier one's
/// value. So that file either has every value of the earlier one, or names it in its first key, with the
/// number of its own values:
///
///     overlay: {base: SkillGetBall.yaml, values: 3}
///
/// Throws ConfigurationError naming file and line for anything else, also where the number is wrong.
void layOver(ConfigNode& base, ConfigNode over);

/// The line that such a file begins with, for programs that write one.
std::string overlayLine(const std::string& baseName, std::size_t values);

}  // namespace plumbline
