#include "gap/inference/SetSearch.h"

#include <algorithm>

#include "gap/inference/FreeCoefficients.h"
#include "gap/inference/LinearSearch.h"
#include "gap/inference/PossibleKinds.h"
#include "gap/inference/Visible.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostJudged = 13;                      // sets that are kept
constexpr int rounds = 6, quickRounds = 4;                  // of new derivatives
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

/// Adds proposals, scored by free replays and the price of so many kinds.
void addScored(const Replayer& replayer, std::vector<SetProposal> proposals, std::size_t kinds,
               std::vector<SetProposal>& answers) {
  for (SetProposal& proposal : proposals) {
    const auto judge = [&](Scored& set) {
      set.gain = gainsOf(replayer, set.causes(), set.without);
      set.price = priceOf(set.causes().size(), kinds);
    };
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
  FreeCoefficients coefficients(options.quick ? *tools.coarse : replayer);
  LinearSearchOptions search;
  search.mostCauses = options.mostCauses;
  search.rounds = options.quick ? quickRounds : rounds;
  search.mostSettled = options.quick ? quickFittedSets : fittedSets;
  search.idleCauses = [&](const Explanation& causes) { return idleCauses(replayer, causes); };
  search.progress = partOf(options.progress, options.expectMany ? 0 : 0.3, 1);
  const Shares nominal = sharesOf(replayer.groups(), replayer.residuals({}));
  // The best small set stopped at the limit, so it is no rival of large sets.
  const std::size_t kinds = possibleKinds(replayer.groups(), replayer.mechanism()).size();
  std::vector<SetProposal> answers{{score(replayer, nominal, {}, kinds, 0), {}}};
  addScored(replayer, proposedSets(coefficients, search), kinds, answers);
  const bool anyCause =
      std::ranges::any_of(answers, [](const SetProposal& of) { return !of.set.causes().empty(); });
  if (!anyCause && !few.sets.empty()) return few;
  return chosen(answers, few.sets, kinds);
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
