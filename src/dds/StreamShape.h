#pragma once
#include <cstdint>

#include "framework/Representation.h"

namespace plumbline::dds {

/// A hash of the names and types of what a representation streams. Two agents whose programs differ in them
/// must not accept each other's data.
std::uint64_t shapeOf(Representation& value);

}  // namespace plumbline::dds
