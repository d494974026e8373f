#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/record/Excitation.h"

namespace plumbline::gap {

/// One effect of the library at one place, drawn by the seed, of a size that the programs show: the gap in
/// the channel that shows it best is 6 to 60 times that channel's noise. Effects that stay hidden in these
/// programs are not drawn. Throws std::runtime_error where none is found.
Cause drawSecret(const Mechanism& robot, const std::vector<Excitation>& programs, std::uint64_t seed);

/// A text that cannot be read by mistake; not proof against who wants to read it.
std::string seal(const std::string& text, std::uint64_t salt);
/// The text that was sealed. Throws std::invalid_argument for what is no sealed text.
std::string unseal(const std::string& sealed);

}  // namespace plumbline::gap
