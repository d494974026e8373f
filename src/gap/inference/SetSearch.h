#pragma once
#include "gap/inference/Beam.h"
#include "gap/inference/WindowReplayer.h"

namespace plumbline::gap {

/// What sets of causes are searched with, all for the same groups.
struct SearchTools {
  const Replayer& replayer;           ///< that sets are judged by
  WindowReplayer* windows = nullptr;  ///< of a robot with few kinds of causes
  /// Of a robot with many kinds of causes: with long steps (withLongSteps). Sets are proposed and fitted
  /// with it.
  const Replayer* coarse = nullptr;

  /// See Replayer.
  std::size_t numAsked() const {
    return replayer.numAsked() + (coarse ? coarse->numAsked() : 0) + (windows ? windows->numAsked() : 0);
  }
};

/// Causes of a robot with many kinds of causes that are fitted set by set.
inline constexpr std::size_t mostSetBySet = 3;

struct SetSearchOptions : BeamOptions {
  bool quick = false;       ///< a search that is one of many
  bool expectMany = false;  ///< more causes than mostSetBySet: derivatives propose sets at once
  /// Settings that are tried with these values and recordings; empty: in a search that is not quick, those
  /// that proposedSettings() finds.
  Explanation settings = {};
};

/// Of a search that is one of many: narrower.
SetSearchOptions quickly(SetSearchOptions options);

/// Searches for the set of causes with the best score (doc/decisions/0013). Few kinds are searched in two
/// ways, by fits to free replays (searchSets) and by what windows propose. Of many kinds, sets are proposed
/// by derivatives of free replays. With neither tool free replays alone are fitted. One score judges all
/// sets: what free replays gain in the groups left out. Where something remains unexplained, settings that
/// were not in force in each recording are tried in addition (proposedSettings).
BeamResult searchForSets(const SearchTools& tools, const SetSearchOptions& options);

/// What was found, with other sets judged by the same score: each is fitted from its values to all groups, of
/// those with the same causes the first. The best becomes the answer, unless one of its causes does nothing.
BeamResult withOthers(const Replayer& replayer, BeamResult found, const std::vector<Explanation>& others,
                      const SetSearchOptions& options);

}  // namespace plumbline::gap
