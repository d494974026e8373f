#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/record/Excitation.h"

namespace plumbline::gap {

/// Draws one effect of the library at one place by the seed. Its size is such that the programs show it: the
/// gap in the best channel is 6 to 60 times that channel's noise. Effects that do not show in these programs
/// are not drawn. Throws std::runtime_error if none is found.
Cause drawSecret(const Mechanism& robot, const std::vector<Excitation>& programs, std::uint64_t seed);

/// A text that nobody reads by accident; not protected against somebody who wants to read it.
std::string seal(const std::string& text, std::uint64_t salt);
/// The text that was sealed. Throws std::invalid_argument for other text.
std::string unseal(const std::string& sealed);

}  // namespace plumbline::gap
