#pragma once
#include <string>

namespace plumbline {

/// Writes the whole file beside its place and renames it there, so that a reader never sees half of it.
/// Throws std::runtime_error "cannot write PATH: REASON".
void writeFile(const std::string& path, const std::string& content);

}  // namespace plumbline
