#include "gap/inference/SetSearch.h"

#include <algorithm>

#include "gap/inference/FreeCoefficients.h"
#include "gap/inference/LinearSearch.h"
#include "gap/inference/PossibleKinds.h"
#include "gap/inference/Visible.h"

namespace plumbline::gap {

namespace {

constexpr int mostJudgements = 4;                     // changes of the best set and its shares
constexpr std::size_t mostJudged = 13;                // sets that are kept
constexpr int rounds = 6, quickRounds = 4;            // of derivatives taken anew
constexpr std::size_t settled = 5, quickSettled = 3;  // sets that are fitted to their end

bool sameKinds(const Explanation& a, const Explanation& b) {
  return a.size() == b.size() && std::ranges::all_of(a, [&](const Cause& cause) {
           return std::ranges::any_of(b, [&](const Cause& other) { return cause.sameKind(other); });
         });
}

bool allVisible(const Replayer& replayer, const Explanation& causes) {
  for (std::size_t i = 0; i < causes.size(); ++i)
    if (!isVisible(replayer, causes, i)) return false;
  return true;
}

std::size_t bestOf(const std::vector<SetProposal>& answers) {
  return static_cast<std::size_t>(
      std::ranges::max_element(answers, {}, [](const SetProposal& of) { return of.set.score(); }) -
      answers.begin());
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

/// Chooses among answers by the one score, under the shares of what the best of them leaves; the first is
/// taken to be the best whose shares are given.
class Judgement {
public:
  Judgement(const Replayer& replayer, std::vector<SetProposal> answers, Shares shares)
      : replayer_(replayer), answers_(std::move(answers)), shares_(std::move(shares)) {
    judgeAll();
    for (int round = 0; round < mostJudgements; ++round) {
      const std::size_t now = bestOf(answers_);
      if (now == best_) break;
      best_ = now;
      shares_ = sharesOf(replayer_.groups(), replayer_.residuals(answers_[best_].set.causes()));
      judgeAll();
    }
  }

  /// With sets that were looked at beside.
  BeamResult result(const std::vector<Scored>& beside, std::size_t kinds) const {
    BeamResult result;
    result.shares = shares_;
    result.kinds = kinds;
    std::vector<Scored> others;
    for (const SetProposal& answer : answers_) others.push_back(answer.set);
    for (const Scored& set : beside) others.push_back(judged(replayer_, shares_, set));
    for (const Scored& rest : answers_[best_].lessOne) {
      result.lessOne.push_back(judged(replayer_, shares_, rest));
      others.push_back(result.lessOne.back());
    }
    const Scored answer = others[best_];
    std::erase_if(others, [&](const Scored& set) { return sameKinds(set.causes(), answer.causes()); });
    result.sets = inOrder(std::move(others));
    result.sets.insert(result.sets.begin(), answer);
    return result;
  }

private:
  void judgeAll() {
    for (SetProposal& answer : answers_) answer.set = judged(replayer_, shares_, answer.set);
  }

  const Replayer& replayer_;
  std::vector<SetProposal> answers_;
  Shares shares_;
  std::size_t best_ = 0;
};

/// Adds proposals whose causes can all be seen, at the price of so many kinds.
void addVisible(const Replayer& replayer, std::vector<SetProposal> proposals, std::size_t kinds,
                std::vector<SetProposal>& answers) {
  for (SetProposal& proposal : proposals) {
    if (!allVisible(replayer, proposal.set.causes())) continue;
    for (Scored& rest : proposal.lessOne) rest.price = priceOf(rest.causes().size(), kinds);
    proposal.set.price = priceOf(proposal.set.causes().size(), kinds);
    answers.push_back(std::move(proposal));
  }
}

using Progress = std::function<void(double)>;

Progress partOf(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double share) { whole(from + (to - from) * share); };
}

BeamResult searchInWindowsToo(const SearchTools& tools, const SetSearchOptions& options) {
  BeamOptions beam = options;
  beam.progress = partOf(options.progress, 0, 0.5);
  const BeamResult found = searchSets(tools.replayer, beam);
  std::vector<SetProposal> answers{{found.sets.front(), found.lessOne}};
  LinearSearchOptions search;
  search.mostCauses = options.mostCauses;
  search.progress = partOf(options.progress, 0.5, 1);
  addVisible(tools.replayer, proposedSets(*tools.windows, search), found.kinds, answers);
  return Judgement(tools.replayer, std::move(answers), found.shares)
      .result({found.sets.begin() + 1, found.sets.end()}, found.kinds);
}

/// Few causes are fitted set by set. Where that ends with as many as it may, derivatives propose larger sets.
BeamResult searchByDerivatives(const SearchTools& tools, const SetSearchOptions& options) {
  const Replayer& replayer = tools.replayer;
  std::vector<Scored> few;
  if (!options.expectMany) {
    BeamOptions beam = options;
    beam.mostCauses = std::min(options.mostCauses, mostSetBySet);
    beam.progress = partOf(options.progress, 0, 0.3);
    BeamResult found = searchSets(replayer, beam);
    const std::size_t size = found.sets.front().causes().size();
    if (size < mostSetBySet || size == options.mostCauses) return found;
    few = std::move(found.sets);
  }
  FreeCoefficients coefficients(options.quick ? *tools.coarse : replayer);
  LinearSearchOptions search;
  search.mostCauses = options.mostCauses;
  search.rounds = options.quick ? quickRounds : rounds;
  search.mostSettled = options.quick ? quickSettled : settled;
  search.progress = partOf(options.progress, options.expectMany ? 0 : 0.3, 1);
  // Under the shares of what a small set leaves, that set would look better than it is beside large ones; and
  // the best of the few ended where it had to, and is no rival of them.
  const Shares shares = sharesOf(replayer.groups(), replayer.residuals({}));
  const std::size_t kinds = possibleKinds(replayer.groups(), replayer.mechanism()).size();
  std::vector<SetProposal> answers{{score(replayer, shares, {}, kinds, 0), {}}};
  addVisible(replayer, proposedSets(coefficients, search), kinds, answers);
  return Judgement(replayer, std::move(answers), shares).result(few, kinds);
}

}  // namespace

Scored judged(const Replayer& replayer, const Shares& shares, Scored set) {
  const Groups& groups = replayer.groups();
  set.density.clear();
  for (std::size_t g = 0; g < groups.count(); ++g) {
    std::vector<char> left(groups.count(), 0);
    left[g] = 1;
    const Residuals residuals = replayer.residuals(set.without[g], trialsOf(groups, left));
    set.density.push_back(densities(groups, residuals, shares, left)[g]);
  }
  return set;
}

BeamResult searchForSets(const SearchTools& tools, const SetSearchOptions& options) {
  if (tools.windows) return searchInWindowsToo(tools, options);
  return tools.coarse ? searchByDerivatives(tools, options) : searchSets(tools.replayer, options);
}

}  // namespace plumbline::gap
