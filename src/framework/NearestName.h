#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// Insertions, deletions, replacements and swaps of neighbours that turn one text into the other; upper and
/// lower case count as half different, rounded down.
unsigned editDistance(std::string_view a, std::string_view b);

/// The candidate with the smallest edit distance to `name`; the first one in the given order if there are
/// several. Empty if none is near enough (a third of the name's length, at least 2).
std::string nearestName(std::string_view name, const std::vector<std::string>& candidates);

/// `; did you mean "x"?`, or nothing.
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace plumbline
