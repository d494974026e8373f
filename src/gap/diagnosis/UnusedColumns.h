#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Why no diagnosis uses signals of a kind; empty: one does.
std::string whyNeverUsed(SignalKind kind);

/// What was recorded and a diagnosis does not use, a line of each kind and reason. whyNot: of a signal of a
/// trial, by their indices; empty: it is used.
std::vector<std::string> unusedColumns(
    const std::vector<Trial>& trials,
    const std::function<std::string(std::size_t trial, std::size_t signal)>& whyNot);

/// The same of a diagnosis by blocks, which looks at what Evidence counts.
std::vector<std::string> unusedByBlocks(const std::vector<Trial>& trials);

}  // namespace plumbline::gap
