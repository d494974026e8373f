#pragma once
#include <string>

#include "framework/Representation.h"

namespace plumbline {

/// True if every floating point number that the representation streams is finite; `numbers` becomes true if
/// it streams any. One without a stream method has no fields to look at and is taken as finite.
bool streamsFiniteNumbers(const Representation& value, bool& numbers);

/// "", or which number is not finite, by its path: "relative.x: must be finite, not nan".
std::string numberProblem(const Representation& value);

}  // namespace plumbline
