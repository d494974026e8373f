#pragma once
#include <functional>
#include <vector>

#include "gap/inference/HoldOut.h"
#include "gap/inference/SetSearch.h"

namespace plumbline::gap {

/// What is found without a group, which therefore had no say in which causes, nor in their values (nested
/// cross-validation: Varma and Simon, BMC Bioinformatics 7, 2006).
struct FoundWithout {
  Explanation causes;
  std::vector<Scored> sets;  ///< of the search, the best first
  std::vector<double> probabilities;
};

/// Runs the search without a group, which so many groups are left for, or has its result from elsewhere.
using SearchWithout = std::function<BeamResult(std::size_t group, std::size_t groupsLeft,
                                               const std::function<BeamResult()>& search)>;

/// One search per group (searchForSets), in the others alone. The tools are those of all groups. The options
/// are read when a search begins. run: null runs each.
std::vector<FoundWithout> findWithoutEach(const SearchTools& tools, const SetSearchOptions& options,
                                          const SearchWithout& run = {});

/// Each recording replayed free with what was found without its group (or, where one recording alone is cut
/// into stretches, each stretch).
std::vector<RecordingLeft> leftWithout(const Groups& groups, const std::vector<FoundWithout>& found);

/// For each set of causes: all recordings replayed free with it, in the order of leftWithout.
std::vector<std::vector<RecordingLeft>> leftWithEach(const Groups& groups,
                                                     const std::vector<Explanation>& sets);

/// Per recording, in the order of leftWithout: its group.
std::vector<std::size_t> groupsOfRecordings(const Groups& groups);

}  // namespace plumbline::gap
