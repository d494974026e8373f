#include "gap/inference/SearchByDerivatives.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "gap/inference/Climb.h"
#include "gap/inference/FreeCoefficients.h"
#include "gap/inference/PartOfProgress.h"
#include "gap/inference/PossibleKinds.h"
#include "gap/inference/SetChoice.h"
#include "gap/inference/SettingMask.h"
#include "gap/inference/SettingSearch.h"
#include "gap/inference/Unexplained.h"

namespace plumbline::gap {

namespace {

constexpr int rounds = 4;                                  // of derivatives
constexpr std::size_t fittedSets = 3;                      // of those that they propose
constexpr std::size_t mostSettings = 3;                    // that are tried
constexpr int mostLooks = 2;                               // from the best set on
constexpr double untilSmall = 0.15, untilProposed = 0.35;  // of a search's progress

/// A set with a setting, in the place of the same effect there.
Explanation withSetting(Explanation causes, const Cause& setting) {
  const auto replaced = [&](const Cause& cause) {
    return cause.effect == setting.effect &&
           (cause.place == setting.place || setting.place.site == Site::everywhere);
  };
  std::erase_if(causes, replaced);
  causes.push_back(setting);
  return causes;
}

class DerivativeSearch {
public:
  DerivativeSearch(const SearchTools& tools, const SetSearchOptions& options)
      : tools_(tools),
        options_(options),
        kinds_(possibleKinds(tools.replayer.groups(), tools.replayer.mechanism()).size()),
        coefficients_(*tools.coarse) {}

  BeamResult run() {
    BeamResult small;
    if (!options_.expectMany) {
      small = smallSets();
      const std::size_t size = small.sets.front().causes().size();
      if (size < mostSetBySet || size == options_.mostCauses) return withMore(std::move(small));
    }
    LinearSearchOptions search;
    search.rounds = rounds;
    search.mostSettled = fittedSets;
    search.progress = partOf(options_.progress, options_.expectMany ? 0 : untilSmall, untilProposed);
    std::vector<SetProposal> answers{{noCauses(), {}}};
    addScored(tools_.replayer, proposed(std::move(search)), kinds_, answers);
    const Scored& best = bestOf(answers).set;
    if (best.causes().empty() && !small.sets.empty()) return withMore(std::move(small));
    Scored set = improved(climbed(tools_, best.causes(), kinds_));
    addScored(tools_.replayer, {withLessOne(*tools_.coarse, std::move(set), kinds_)}, kinds_, answers);
    // The best small set stopped at the limit, so it is no rival of large sets.
    return chosen(answers, small.sets, kinds_);
  }

private:
  /// Sets of few causes, fitted set by set.
  BeamResult smallSets() const {
    BeamOptions beam = static_cast<const BeamOptions&>(options_);
    beam.mostCauses = std::min(options_.mostCauses, mostSetBySet);
    beam.progress = partOf(options_.progress, 0, untilSmall);
    return searchSets(tools_.replayer, beam);
  }

  Scored noCauses() const {
    const Replayer& replayer = tools_.replayer;
    return score(replayer, sharesOf(replayer.groups(), replayer.residuals({})), {}, kinds_, 0);
  }

  /// What was fitted set by set, or with settings.
  BeamResult withMore(BeamResult small) {
    std::vector<SetProposal> answers{{small.sets.front(), small.lessOne}};
    const Scored& known = answers.front().set;
    if (Scored set = improved(known); set.causes() != known.causes())
      addScored(tools_.replayer, {withLessOne(*tools_.coarse, std::move(set), kinds_)}, kinds_, answers);
    return chosen(answers, {small.sets.begin() + 1, small.sets.end()}, kinds_);
  }

  /// Sets that derivatives propose, not yet scored by free replays.
  std::vector<SetProposal> proposed(LinearSearchOptions search) {
    search.mostCauses = options_.mostCauses;
    search.idleCauses = [this](const Explanation& causes) { return idleCauses(tools_.replayer, causes); };
    return proposedSets(coefficients_, search);
  }

  /// Sets that derivatives are taken at: what was found, unless it was fitted set by set, and the same with
  /// settings. A full set loses the cause that it needs least. In a search that is one of many: with the
  /// settings that are given alone.
  std::vector<Explanation> startsFrom(const Scored& found) const {
    std::vector<Explanation> starts, settings;
    if (!options_.settings.empty()) settings.push_back(options_.settings);
    if (!options_.quick) {
      if (found.causes().size() > mostSetBySet) starts.push_back(found.causes());
      if (settings.empty() && recordingsOf(tools_.replayer.groups()).size() > 1)
        for (const Cause& setting : proposedSettings(*tools_.coarse, found.causes(), mostSettings))
          settings.push_back({setting});
    }
    for (const Explanation& more : settings) {
      Explanation start = found.causes();
      if (start.size() + more.size() > options_.mostCauses)
        start = without(start, leastNeeded(*tools_.coarse, found));
      for (const Cause& setting : more) start = withSetting(std::move(start), setting);
      if (start.size() <= options_.mostCauses) starts.push_back(std::move(start));
    }
    return starts;
  }

  /// The best of what derivatives lead to from a set on that leaves something unexplained.
  Scored improved(Scored best) {
    if (worstOf(tools_.replayer, best.causes()).share() <= 1) return best;
    std::vector<Explanation> starts = startsFrom(best);
    for (int look = 0; look < mostLooks && !starts.empty(); ++look) {
      const double from = untilProposed + (1 - untilProposed) * look / mostLooks;
      std::optional<Scored> next;
      for (std::size_t i = 0; i < starts.size(); ++i) {
        std::optional<Scored> set = grown(starts[i], best.causes());
        if (set && (!next || set->score() > next->score())) next = std::move(set);
        if (options_.progress)
          options_.progress(from + (1 - untilProposed) / mostLooks * static_cast<double>(i + 1) /
                                       static_cast<double>(starts.size()));
      }
      if (!next || next->score() <= best.score()) break;
      best = std::move(*next);
      starts = {best.causes()};
    }
    return best;
  }

  /// What derivatives at a set lead to, climbed; none if that is the best set known. Settings keep their
  /// strengths meanwhile: which of them is the right one shows only with what else it needs.
  std::optional<Scored> grown(const Explanation& start, const Explanation& known) {
    LinearSearchOptions search;
    search.rounds = rounds;
    search.mostSettled = 1;
    search.start = start;
    for (const Cause& cause : start)
      if (cause.effect->setting) {
        search.configured.push_back(
            configuredKind(tools_.replayer.groups(), tools_.replayer.mechanism(), cause));
        search.configured.back().lower = search.configured.back().upper = 1;
      }
    const std::vector<SetProposal> found = proposed(std::move(search));
    if (found.empty() || found.front().set.causes().empty()) return std::nullopt;
    const Explanation& causes = found.front().set.causes();
    if (start == known && sameKinds(causes, known)) return std::nullopt;
    Scored set = climbed(tools_, withLikeliestMasks(*tools_.coarse, causes), kinds_);
    if (const Explanation masked = withLikeliestMasks(*tools_.coarse, set.causes()); masked != set.causes())
      if (Scored again = climbed(tools_, masked, kinds_); again.score() > set.score()) set = std::move(again);
    return set;
  }

  const SearchTools& tools_;
  const SetSearchOptions& options_;
  const std::size_t kinds_;
  FreeCoefficients coefficients_;
};

}  // namespace

BeamResult searchByDerivatives(const SearchTools& tools, const SetSearchOptions& options) {
  return DerivativeSearch(tools, options).run();
}

}  // namespace plumbline::gap
