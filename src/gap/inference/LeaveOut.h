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

/// One search per group (searchForSets), in the others alone. The tools are those of all groups.
std::vector<FoundWithout> findWithoutEach(const SearchTools& tools, const SetSearchOptions& options);

/// Each recording replayed free with what was found without its group (or, where one recording alone is cut
/// into stretches, each stretch).
std::vector<RecordingLeft> leftWithout(const Groups& groups, const std::vector<FoundWithout>& found);

/// For each set of causes: all recordings replayed free with it, in the order of leftWithout.
std::vector<std::vector<RecordingLeft>> leftWithEach(const Groups& groups,
                                                     const std::vector<Explanation>& sets);

/// Per recording, in the order of leftWithout: its group.
std::vector<std::size_t> groupsOfRecordings(const Groups& groups);

}  // namespace plumbline::gap
