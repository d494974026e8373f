#pragma once
#include "gap/inference/Beam.h"
#include "gap/inference/WindowReplayer.h"

namespace plumbline::gap {

/// Searches for the set of causes with the best score in two ways: by fits to free replays (searchSets), and,
/// if windows are given, by what windows propose (proposedByWindows). One score judges all sets, with the
/// values that each way found: the density of free replays of the groups left out. windows: of the same
/// groups; null: free replays alone.
BeamResult searchBothWays(const Replayer& replayer, WindowReplayer* windows,
                          const BeamOptions& options);

/// The set, scored anew under these shares with the values that it has without each group.
Scored judged(const Replayer& replayer, const Shares& shares, Scored set);

}  // namespace plumbline::gap
