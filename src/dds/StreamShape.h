#pragma once
#include <cstdint>

#include "framework/Representation.h"

namespace plumbline::dds {

/// A number that stands for the names and types of what a representation streams: two agents whose programs
/// differ in them must not take each other's bytes for their own.
std::uint64_t shapeOf(Representation& value);

}  // namespace plumbline::dds
