#pragma once
#include <functional>

#include "gap/inference/Beam.h"
#include "gap/inference/WindowReplayer.h"

namespace plumbline::gap {

struct WindowSearchOptions {
  std::size_t mostCauses = 8;
  std::function<void(double share)> progress = {};
};

/// Searches for the set of causes with the best score in windows that are replayed from the measured state.
/// Moves (add a cause, drop one, put another in its place) are judged by derivatives beside the set itself; a
/// set that is better so is fitted by replays, and the derivatives are taken anew beside it.
BeamResult searchInWindows(const WindowReplayer& replayer, const WindowSearchOptions& options);

}  // namespace plumbline::gap
