#include "gap/inference/StagedSearch.h"

#include <algorithm>

#include "gap/inference/CauseKinds.h"
#include "gap/inference/PossibleKinds.h"
#include "gap/inference/Posterior.h"
#include "gap/inference/RuledOut.h"
#include "gap/inference/SetSearch.h"
#include "gap/inference/Unexplained.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostOfManyKinds = 12;  // causes in a set of a robot with more
const std::string setsOfCauses = "sets of causes";
const std::string setsOnFeet = "sets of causes on the feet";

/// A set as it is judged without a group, with the values that it has then.
Scored withoutGroup(const Scored& set, std::size_t group) {
  Scored other;
  other.fitted.causes = set.without[group];
  other.price = set.price;
  for (std::size_t g = 0; g < set.gain.size(); ++g)
    if (g != group) other.gain.push_back(set.gain[g]), other.without.push_back(set.without[g]);
  return other;
}

/// The choice among the sets that were found, made again without each group.
std::vector<FoundWithout> chosenWithoutEach(const std::vector<Scored>& sets, std::size_t groups) {
  std::vector<FoundWithout> chosen;
  for (std::size_t g = 0; g < groups; ++g) {
    FoundWithout& of = chosen.emplace_back();
    for (const Scored& set : sets) of.sets.push_back(withoutGroup(set, g));
    std::ranges::stable_sort(of.sets, std::ranges::greater(), &Scored::score);
    of.causes = of.sets.front().causes();
    of.probabilities = posterior(of.sets);
  }
  return chosen;
}

}  // namespace

StagedSearch::StagedSearch(const Replayer& whole, const InferenceOptions& options,
                           const std::vector<Prediction>& predicted, std::string name, StagedSearch* alike)
    : whole_(whole), options_(options), name_(std::move(name)), alike_(alike) {
  const std::vector<Trial>& trials = whole_.groups().trials();
  const bool anyFree = std::ranges::any_of(trials, &Trial::freeBase),
             anyFixed = !std::ranges::all_of(trials, &Trial::freeBase);
  twoStages_ = anyFree && anyFixed;
  if (twoStages_) {
    std::vector<Trial> fixed;
    std::vector<Prediction> predictedOfFixed;
    for (std::size_t t = 0; t < trials.size(); ++t) {
      if (trials[t].freeBase) continue;
      fixed.push_back(trials[t]);
      if (!predicted.empty()) predictedOfFixed.push_back(predicted[t]);
    }
    stages_.push_back(std::make_unique<SearchStage>(
        whole_.mechanism(), Groups(std::move(fixed), predictedOfFixed), options.jobs));
  } else {
    stages_.push_back(std::make_unique<SearchStage>(whole_, whole_.groups()));
  }
  const SearchStage& first = *stages_.front();
  few_ = hasFewKinds(first.groups, whole_.mechanism());
  if (!anyFixed) return;
  if (few_)
    windows_.emplace(whole_.mechanism(), first.groups, options.jobs);
  else
    coarse_.emplace(whole_.mechanism(), first.groups, options.jobs, withLongSteps());
}

std::size_t StagedSearch::numAsked() const {
  return whole_.numAsked() + (twoStages_ ? stages_.front()->replayer.numAsked() : 0) +
         (coarse_ ? coarse_->numAsked() : 0) + (windows_ ? windows_->numAsked() : 0);
}

std::size_t StagedSearch::mostCauses() const {
  if (options_.mostCauses > 0) return options_.mostCauses;
  return few_ ? SetSearchOptions().mostCauses : mostOfManyKinds;
}

SearchTools StagedSearch::tools() {
  return {stages_.front()->replayer, windows_ ? &*windows_ : nullptr, coarse()};
}

const CandidateScreening& StagedSearch::screening(StoredParts& parts) {
  if (alike_) return alike_->screening(parts);
  if (!screening_) {
    parts.uncounted([&] {
      const SearchStage& stage = *stages_.front();
      report("each cause alone", 0);
      ScreeningOptions each;
      each.progress = [&](double share) { report("each cause alone", share); };
      screening_.emplace(stage.replayer, sharesOf(stage.groups, stage.replayer.residuals({})), each);
    });
  }
  return *screening_;
}

BeamResult StagedSearch::searchAllKinds(const std::string& part, std::size_t groups, StoredParts& parts,
                                        const std::function<BeamResult()>& run) {
  if (!parts.holdsSearch(part, groups)) search_.screening = &screening(parts);
  return parts.search(part, groups, run);
}

void StagedSearch::findFirst(StoredParts& parts, bool expectMany) {
  search_ = {};
  search_.expectMany = coarse_ && expectMany;
  search_.mostCauses = mostCauses();
  find(setsOfCauses + name_, parts);
}

void StagedSearch::findFew(StoredParts& parts) {
  search_ = quickly({});
  search_.mostCauses = std::min(mostSetBySet, mostCauses());
  find(setsOfCauses + name_ + ", few", parts);
}

void StagedSearch::find(const std::string& part, StoredParts& parts) {
  SearchStage& stage = *stages_.front();
  search_.progress = [&](double share) { report(setsOfCauses.c_str(), share); };
  stage.found =
      searchAllKinds(part, stage.groups.count(), parts, [&] { return searchForSets(tools(), search_); });
  stage.probabilities = posterior(stage.found.sets);
}

void StagedSearch::finish(StoredParts& parts) {
  SearchStage& first = *stages_.front();
  for (const Cause& cause : first.best().causes())
    if (!cause.inactiveIn.empty()) search_.settings.push_back(cause);
  search_.expectMany = coarse_ && first.best().causes().size() > mostSetBySet;
  search_.progress = [&](double share) { report("again without each recording in turn", share); };
  first.without = findWithoutEach(tools(), search_, [&](std::size_t g, std::size_t left, const auto& run) {
    return searchAllKinds(setsOfCauses + name_ + nameWithout(g), left, parts, run);
  });
  // A search among many kinds can end where a part of the recordings would not have led it. Few kinds are
  // tried more thoroughly.
  std::vector<Explanation> others;
  for (const FoundWithout& of : first.without)
    if (coarse_ && !of.causes.empty()) others.push_back(of.causes);
  if (!others.empty()) {
    first.found = withOthers(first.replayer, std::move(first.found), others, search_);
    first.probabilities = posterior(first.found.sets);
  }
  if (!twoStages_) return;
  Explanation base = whole_.base();
  base.insert(base.end(), first.best().causes().begin(), first.best().causes().end());
  stages_.push_back(
      std::make_unique<SearchStage>(whole_, whole_.groups().withFixedBaseAsOne(), std::move(base)));
  SearchStage& second = *stages_.back();
  if (worstOf(second.replayer, {}, leastSearchedOnFeet).share() > 1) {
    searchKindsLeft(second, parts);
  } else {
    const Shares shares = sharesOf(second.groups, second.replayer.residuals({}));
    const std::size_t kinds = possibleKinds(second.groups, whole_.mechanism()).size();
    second.found = {{score(second.replayer, shares, {}, kinds, 0)}, {}, kinds};
  }
  second.probabilities = posterior(second.found.sets);
  second.without = chosenWithoutEach(second.found.sets, second.groups.count());
}

void StagedSearch::searchKindsLeft(SearchStage& stage, StoredParts& parts) {
  const SearchStage& first = *stages_.front();
  SetSearchOptions search;
  search.mostCauses =
      std::min(mostSetBySet, mostCauses() - std::min(mostCauses(), first.best().causes().size()));
  // A fit takes a dozen replays of each recording on the feet.
  search.width = 1;
  search.proposals = 3;
  search.fitSteps = 2;
  search.lastSteps = 4;
  search.lastLeaveOut = LeaveOut::newtonStep;
  search.progress = [&](double share) { report(setsOnFeet.c_str(), share); };
  stage.found = parts.search(setsOnFeet + name_, stage.groups.count(), [&] {
    const Replayer hung(coarse_ ? *coarse_ : first.replayer, first.groups, stage.replayer.base());
    const RuledOut ruledOut(hung, possibleKinds(stage.groups, whole_.mechanism()),
                            [&](double share) { report("what hung recordings rule out", share); });
    ScreeningOptions left;
    left.progress = [&](double share) { report("each other cause on the feet", share); };
    left.startFor = [&](const Cause& start) { return ruledOut.startFor(start); };
    const CandidateScreening screening(stage.replayer, sharesOf(stage.groups, stage.replayer.residuals({})),
                                       left);
    search.screening = &screening;
    return searchSets(stage.replayer, search);
  });
}

Explanation StagedSearch::causes() const {
  Explanation all;
  for (const auto& stage : stages_)
    all.insert(all.end(), stage->best().causes().begin(), stage->best().causes().end());
  return all;
}

std::vector<FoundWithout> StagedSearch::withoutEach() const {
  if (!twoStages_) return stages_.front()->without;
  const SearchStage &first = *stages_.front(), &second = *stages_.back();
  const Groups& all = whole_.groups();
  std::vector<FoundWithout> found(all.count());
  for (std::size_t t = 0, hung = 0; t < all.trials().size(); ++t) {
    const bool fixed = !all.trials()[t].freeBase;
    Explanation& causes = found[all.groupOf(t, 0)].causes;
    causes = first.best().causes();
    // Of one recording that is cut into stretches nothing is known without it.
    if (fixed)
      causes =
          first.groups.stretchesOfOne() ? Explanation() : first.without[first.groups.groupOf(hung, 0)].causes;
    hung += fixed ? 1 : 0;
    const Explanation& more = second.without[second.groups.groupOf(t, 0)].causes;
    causes.insert(causes.end(), more.begin(), more.end());
  }
  return found;
}

}  // namespace plumbline::gap
