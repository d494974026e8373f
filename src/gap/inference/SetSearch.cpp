#include "gap/inference/SetSearch.h"

#include <algorithm>

#include "gap/inference/Climb.h"
#include "gap/inference/PartOfProgress.h"
#include "gap/inference/SearchByDerivatives.h"
#include "gap/inference/SetChoice.h"

namespace plumbline::gap {

namespace {

BeamResult searchInWindowsToo(const SearchTools& tools, const SetSearchOptions& options) {
  BeamOptions beam = static_cast<const BeamOptions&>(options);
  beam.progress = partOf(options.progress, 0, 0.5);
  const BeamResult found = searchSets(tools.replayer, beam);
  std::vector<SetProposal> answers{{found.sets.front(), found.lessOne}};
  LinearSearchOptions search;
  search.mostCauses = options.mostCauses;
  search.progress = partOf(options.progress, 0.5, 1);
  std::vector<SetProposal> proposals = proposedSets(*tools.windows, search);
  std::erase_if(proposals,
                [&](const SetProposal& of) { return !idleCauses(tools.replayer, of.set.causes()).empty(); });
  addScored(tools.replayer, std::move(proposals), found.kinds, answers);
  return chosen(answers, {found.sets.begin() + 1, found.sets.end()}, found.kinds);
}

}  // namespace

SetSearchOptions quickly(SetSearchOptions options) {
  options.quick = true;
  options.width = 1;
  options.proposals = 3;
  return options;
}

BeamResult searchForSets(const SearchTools& tools, const SetSearchOptions& options) {
  if (tools.windows) return searchInWindowsToo(tools, options);
  return tools.coarse ? searchByDerivatives(tools, options) : searchSets(tools.replayer, options);
}

BeamResult withOthers(const Replayer& replayer, BeamResult found, const std::vector<Explanation>& others,
                      const SetSearchOptions& options) {
  const Shares shares = sharesOf(replayer.groups(), replayer.residuals(found.sets.front().causes()));
  const auto judged = [&](const Explanation& causes) {
    return score(replayer, shares, causes, found.kinds, options.lastSteps, options.lastLeaveOut);
  };
  std::vector<SetProposal> answers{{found.sets.front(), found.lessOne}};
  for (auto one = others.begin(); one != others.end(); ++one) {
    const Explanation& causes = *one;
    const auto alike = [&](const Explanation& other) { return sameKinds(other, causes); };
    if (alike(answers.front().set.causes()) || std::any_of(others.begin(), one, alike)) continue;
    Scored set = judged(causes);
    if (set.score() <= answers.front().set.score()) {
      found.sets.push_back(std::move(set));
      continue;
    }
    if (!idleCauses(replayer, set.causes()).empty()) continue;
    answers.push_back(withLessOne(replayer, std::move(set), found.kinds));
  }
  return chosen(answers, {found.sets.begin() + 1, found.sets.end()}, found.kinds);
}

}  // namespace plumbline::gap
