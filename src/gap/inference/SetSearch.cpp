#include "gap/inference/SetSearch.h"

#include <algorithm>

#include "gap/inference/Visible.h"
#include "gap/inference/WindowSearch.h"

namespace plumbline::gap {

namespace {

constexpr int mostJudgements = 4;       // changes of the best set and its shares
constexpr std::size_t mostJudged = 13;  // sets that are kept

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

std::size_t bestOf(const std::vector<WindowProposal>& answers) {
  return static_cast<std::size_t>(
      std::ranges::max_element(answers, {}, [](const WindowProposal& of) { return of.set.score(); }) -
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

BeamResult searchBothWays(const Replayer& replayer, WindowReplayer* windows,
                          const BeamOptions& options) {
  const auto part = [&](double from, double to) -> std::function<void(double)> {
    if (!options.progress) return {};
    return [&, from, to](double share) { options.progress(from + (to - from) * share); };
  };
  BeamOptions beam = options;
  beam.progress = part(0, windows ? 0.5 : 1);
  BeamResult found = searchSets(replayer, beam);
  if (!windows) return found;

  std::vector<WindowProposal> answers{{found.sets.front(), found.lessOne}};
  for (WindowProposal& proposal :
       proposedByWindows(*windows, {.mostCauses = options.mostCauses, .progress = part(0.5, 1)})) {
    if (!allVisible(replayer, proposal.set.causes())) continue;
    for (Scored& rest : proposal.lessOne) rest.price = priceOf(rest.causes().size(), found.kinds);
    proposal.set.price = priceOf(proposal.set.causes().size(), found.kinds);
    answers.push_back(std::move(proposal));
  }
  const auto judgeAll = [&] {
    for (WindowProposal& answer : answers) answer.set = judged(replayer, found.shares, answer.set);
  };
  judgeAll();
  std::size_t best = 0;
  for (int round = 0; round < mostJudgements; ++round) {
    const std::size_t now = bestOf(answers);
    if (now == best) break;
    best = now;
    // Shares are those of what the best set leaves.
    found.shares = sharesOf(replayer.groups(), replayer.residuals(answers[best].set.causes()));
    judgeAll();
  }
  std::vector<Scored> others;
  for (const WindowProposal& answer : answers) others.push_back(answer.set);
  for (std::size_t i = 1; i < found.sets.size(); ++i)
    others.push_back(judged(replayer, found.shares, found.sets[i]));
  found.lessOne.clear();
  for (const Scored& rest : answers[best].lessOne)
    found.lessOne.push_back(judged(replayer, found.shares, rest)), others.push_back(found.lessOne.back());
  const Scored answer = others[best];
  std::erase_if(others, [&](const Scored& set) { return sameKinds(set.causes(), answer.causes()); });
  found.sets = inOrder(std::move(others));
  found.sets.insert(found.sets.begin(), answer);
  return found;
}

}  // namespace plumbline::gap
