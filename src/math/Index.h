#pragma once
#include <cstddef>

namespace plumbline {

/// A number of a joint, link or foot, which may be -1 for none, as a container's index.
constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace plumbline
