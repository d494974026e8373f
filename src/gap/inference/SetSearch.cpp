#include "gap/inference/SetSearch.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "gap/inference/FreeCoefficients.h"
#include "gap/inference/LinearSearch.h"
#include "gap/inference/PossibleKinds.h"
#include "gap/inference/SettingMask.h"
#include "gap/inference/SettingSearch.h"
#include "gap/inference/Unexplained.h"
#include "gap/inference/Visible.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostJudged = 13;                      // sets that are kept
constexpr int rounds = 6, quickRounds = 4;                  // of new derivatives
constexpr std::size_t mostSettings = 4;                     // that are tried
constexpr double toSettings = 0.5;                          // of a search's progress
constexpr int settingRounds = 2;                            // rounds of derivatives that each of these gets
constexpr double settingHeld = 1.08;                        // how far its strength moves meanwhile
constexpr std::size_t fittedSets = 5, quickFittedSets = 3;  // sets that are fitted to their end

bool sameKinds(const Explanation& a, const Explanation& b) {
  return a.size() == b.size() && std::ranges::all_of(a, [&](const Cause& cause) {
           return std::ranges::any_of(b, [&](const Cause& other) { return cause.sameKind(other); });
         });
}

/// Those that do nothing that the replay shows, by index. A cause at its bound can do nothing and still
/// change the replay: its kind is replayed in finer steps.
std::vector<std::size_t> idleCauses(const Replayer& replayer, const Explanation& causes) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < causes.size(); ++i)
    if (doesNothing(replayer.mechanism(), causes[i]) || !isVisible(replayer, causes, i)) found.push_back(i);
  return found;
}

/// Sets in descending order of score; of those with the same causes the best alone.
std::vector<Scored> inOrder(std::vector<Scored> sets) {
  std::ranges::stable_sort(sets, std::ranges::greater(), &Scored::score);
  std::vector<Scored> kept;
  for (Scored& set : sets)
    if (kept.size() < mostJudged && std::ranges::none_of(kept, [&](const Scored& known) {
          return sameKinds(known.causes(), set.causes());
        }))
      kept.push_back(std::move(set));
  return kept;
}

/// The best of the answers by the one score, with the others, the sets also looked at, and the answer
/// without each of its causes.
BeamResult chosen(const std::vector<SetProposal>& answers, const std::vector<Scored>& alsoTried,
                  std::size_t kinds) {
  const auto best =
      std::ranges::max_element(answers, {}, [](const SetProposal& of) { return of.set.score(); });
  const Scored answer = best->set;
  BeamResult result{{}, best->lessOne, kinds};
  std::vector<Scored> others = alsoTried;
  for (const SetProposal& of : answers) others.push_back(of.set);
  others.insert(others.end(), result.lessOne.begin(), result.lessOne.end());
  std::erase_if(others, [&](const Scored& set) { return sameKinds(set.causes(), answer.causes()); });
  result.sets = inOrder(std::move(others));
  result.sets.insert(result.sets.begin(), answer);
  return result;
}

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

/// Adds proposals, scored by free replays and the price of so many kinds.
void addScored(const Replayer& replayer, std::vector<SetProposal> proposals, std::size_t kinds,
               std::vector<SetProposal>& answers) {
  const std::vector<std::string> recordings = recordingsOf(replayer.groups());
  const auto judge = [&](Scored& set) {
    set.gain = gainsOf(replayer, set.causes(), set.without);
    set.price = priceOf(set.causes().size(), kinds) + priceOfMasks(set.causes(), recordings);
  };
  for (SetProposal& proposal : proposals) {
    judge(proposal.set);
    for (Scored& rest : proposal.lessOne) judge(rest);
    answers.push_back(std::move(proposal));
  }
}

using Progress = std::function<void(double)>;

Progress partOf(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double share) { whole(from + (to - from) * share); };
}

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

/// Sets that derivatives propose, scored by free replays.
std::vector<SetProposal> proposedByDerivatives(const SearchTools& tools, const SetSearchOptions& options,
                                               std::size_t kinds, LinearSearchOptions search) {
  const Replayer& replayer = tools.replayer;
  FreeCoefficients coefficients(options.quick ? *tools.coarse : replayer);
  search.mostCauses = options.mostCauses;
  search.idleCauses = [&](const Explanation& causes) { return idleCauses(replayer, causes); };
  std::vector<SetProposal> answers;
  addScored(replayer, proposedSets(coefficients, search), kinds, answers);
  return answers;
}

/// How long derivatives propose sets from nothing on.
LinearSearchOptions wholeSearch(const SetSearchOptions& options, Progress progress) {
  LinearSearchOptions search;
  search.rounds = options.quick ? quickRounds : rounds;
  search.mostSettled = options.quick ? quickFittedSets : fittedSets;
  search.progress = std::move(progress);
  return search;
}

/// Few causes are fitted set by set. If that ends at the limit of causes, derivatives propose larger sets.
BeamResult searchByDerivatives(const SearchTools& tools, const SetSearchOptions& options) {
  const Replayer& replayer = tools.replayer;
  BeamResult few;
  if (!options.expectMany) {
    BeamOptions beam = static_cast<const BeamOptions&>(options);
    beam.mostCauses = std::min(options.mostCauses, mostSetBySet);
    beam.progress = partOf(options.progress, 0, 0.3);
    few = searchSets(replayer, beam);
    const std::size_t size = few.sets.front().causes().size();
    if (size < mostSetBySet || size == options.mostCauses) return few;
  }
  const Shares nominal = sharesOf(replayer.groups(), replayer.residuals({}));
  // The best small set stopped at the limit, so it is no rival of large sets.
  const std::size_t kinds = possibleKinds(replayer.groups(), replayer.mechanism()).size();
  std::vector<SetProposal> answers{{score(replayer, nominal, {}, kinds, 0), {}}};
  for (SetProposal& proposal :
       proposedByDerivatives(tools, options, kinds,
                             wholeSearch(options, partOf(options.progress, options.expectMany ? 0 : 0.3, 1))))
    answers.push_back(std::move(proposal));
  const bool anyCause =
      std::ranges::any_of(answers, [](const SetProposal& of) { return !of.set.causes().empty(); });
  if (!anyCause && !few.sets.empty()) return few;
  return chosen(answers, few.sets, kinds);
}

/// Derivatives from a set on that has settings in it.
LinearSearchOptions searchFrom(const Groups& groups, const Mechanism& robot, const Explanation& start,
                               int rounds) {
  LinearSearchOptions search;
  search.rounds = rounds;
  search.mostSettled = 1;
  search.start = start;
  for (const Cause& cause : start)
    if (cause.effect->setting) search.configured.push_back(configuredKind(groups, robot, cause));
  return search;
}

/// The best set that comes of a set with some settings. Which setting is the right one shows only with what
/// else it needs: a search by derivatives keeps them, nearly as strong as they are. Then the recordings that
/// lacked them show, too, and it is done once more.
std::vector<SetProposal> grownFrom(const SearchTools& tools, Explanation start, std::size_t kinds,
                                   const SetSearchOptions& options) {
  std::vector<SetProposal> answers;
  for (int look = 0; look < 2; ++look) {
    LinearSearchOptions search =
        searchFrom(tools.replayer.groups(), tools.replayer.mechanism(), start, settingRounds);
    search.keepsConfigured = true;
    for (CauseKind& kind : search.configured) kind.lower = 1 / settingHeld, kind.upper = settingHeld;
    std::vector<SetProposal> found = proposedByDerivatives(tools, quickly(options), kinds, std::move(search));
    if (found.empty()) break;
    const Explanation causes = found.front().set.causes();
    answers.push_back(std::move(found.front()));
    start = withLikeliestMasks(*tools.coarse, causes);
    if (start == causes) break;
  }
  return answers;
}

/// A set fitted anew, and the best of its parts.
std::vector<SetProposal> refitted(const SearchTools& tools, const Explanation& causes, std::size_t kinds,
                                  const SetSearchOptions& options) {
  LinearSearchOptions parts = searchFrom(tools.replayer.groups(), tools.replayer.mechanism(), causes, 0);
  parts.mostSettled = 2;
  return proposedByDerivatives(tools, options, kinds, std::move(parts));
}

/// Sets with a setting more, to begin with; with those that are given, all at once. A full set loses the
/// cause that it needs least.
std::vector<Explanation> withMoreSettings(const SearchTools& tools, const BeamResult& found,
                                          const SetSearchOptions& options) {
  const Explanation& causes = found.sets.front().causes();
  const auto with = [&](const Explanation& settings) {
    Explanation start = causes;
    if (causes.size() + settings.size() > options.mostCauses && !found.lessOne.empty())
      start = std::ranges::max_element(found.lessOne, {}, &Scored::score)->causes();
    for (const Cause& setting : settings) start = withSetting(std::move(start), setting);
    return start;
  };
  std::vector<Explanation> starts;
  if (!options.settings.empty())
    starts.push_back(with(options.settings));
  else
    for (const Cause& setting : proposedSettings(*tools.coarse, causes, mostSettings))
      starts.push_back(with({setting}));
  std::erase_if(starts, [&](const Explanation& start) { return start.size() > options.mostCauses; });
  return starts;
}

/// Tries settings that some recordings were made without. They stay where they make a better answer.
BeamResult withSettings(const SearchTools& tools, BeamResult found, const SetSearchOptions& options) {
  const Replayer& replayer = tools.replayer;
  const Scored answer = found.sets.front();
  if (recordingsOf(replayer.groups()).size() < 2 || worstOf(replayer, answer.causes()).share() <= 1)
    return found;
  std::vector<SetProposal> answers{{answer, found.lessOne}};
  const auto add = [&](std::vector<SetProposal> proposals) {
    std::ranges::move(proposals, std::back_inserter(answers));
  };
  const auto best = [&]() -> const Scored& {
    return std::ranges::max_element(answers, {}, [](const SetProposal& of) { return of.set.score(); })->set;
  };
  const std::vector<Explanation> starts = withMoreSettings(tools, found, options);
  for (const Explanation& start : starts) {
    add(grownFrom(tools, start, found.kinds, options));
    if (options.progress)
      options.progress(toSettings + (1 - toSettings) * static_cast<double>(answers.size() - 1) /
                                        static_cast<double>(2 * starts.size() + 1));
  }
  // Until now their strengths were held.
  const Explanation masked = withLikeliestMasks(replayer, best().causes());
  if (masked != answer.causes()) add(refitted(tools, masked, found.kinds, options));
  return chosen(answers, {found.sets.begin() + 1, found.sets.end()}, found.kinds);
}

BeamResult searchKinds(const SearchTools& tools, const SetSearchOptions& options) {
  if (tools.windows) return searchInWindowsToo(tools, options);
  return tools.coarse ? searchByDerivatives(tools, options) : searchSets(tools.replayer, options);
}

}  // namespace

SetSearchOptions quickly(SetSearchOptions options) {
  options.quick = true;
  options.width = 1;
  options.proposals = 3;
  return options;
}

BeamResult searchForSets(const SearchTools& tools, const SetSearchOptions& options) {
  // Of one motor, a setting that some recordings lack is what any misfit of those looks like.
  if (!tools.coarse || (options.quick && options.settings.empty())) return searchKinds(tools, options);
  SetSearchOptions first = options;
  first.progress = partOf(options.progress, 0, toSettings);
  return withSettings(tools, searchKinds(tools, first), options);
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
    SetProposal proposal{judged(causes), {}};
    if (proposal.set.score() <= answers.front().set.score()) {
      found.sets.push_back(std::move(proposal.set));
      continue;
    }
    if (!idleCauses(replayer, proposal.set.causes()).empty()) continue;
    for (std::size_t i = 0; i < causes.size(); ++i) {
      Explanation rest = proposal.set.causes();
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      proposal.lessOne.push_back(judged(rest));
    }
    answers.push_back(std::move(proposal));
  }
  return chosen(answers, {found.sets.begin() + 1, found.sets.end()}, found.kinds);
}

}  // namespace plumbline::gap
