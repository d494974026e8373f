#include "gap/inference/SetChoice.h"

#include <algorithm>

#include "gap/inference/SettingMask.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostJudged = 13;  // sets that are kept

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

bool sameKinds(const Explanation& a, const Explanation& b) {
  return a.size() == b.size() && std::ranges::all_of(a, [&](const Cause& cause) {
           return std::ranges::any_of(b, [&](const Cause& other) { return cause.sameKind(other); });
         });
}

const SetProposal& bestOf(const std::vector<SetProposal>& proposals) {
  return *std::ranges::max_element(proposals, {}, [](const SetProposal& of) { return of.set.score(); });
}

BeamResult chosen(const std::vector<SetProposal>& answers, const std::vector<Scored>& alsoTried,
                  std::size_t kinds) {
  const SetProposal& best = bestOf(answers);
  const Scored& answer = best.set;
  BeamResult result{{}, best.lessOne, kinds};
  std::vector<Scored> others = alsoTried;
  for (const SetProposal& of : answers) others.push_back(of.set);
  others.insert(others.end(), result.lessOne.begin(), result.lessOne.end());
  std::erase_if(others, [&](const Scored& set) { return sameKinds(set.causes(), answer.causes()); });
  result.sets = inOrder(std::move(others));
  result.sets.insert(result.sets.begin(), answer);
  return result;
}

void addScored(const Replayer& replayer, std::vector<SetProposal> proposals, std::size_t kinds,
               std::vector<SetProposal>& answers) {
  const std::vector<std::string> recordings = recordingsOf(replayer.groups());
  const auto judge = [&](Scored& set) {
    set.gain = gainsOf(replayer, set.causes(), set.without);
    set.price = priceOf(set.causes().size(), kinds) + priceOfMasks(set.causes(), recordings);
  };
  for (SetProposal& proposal : proposals) {
    judge(proposal.set);
    if (answers.empty() || proposal.set.score() > bestOf(answers).set.score())
      for (Scored& rest : proposal.lessOne) judge(rest);
    answers.push_back(std::move(proposal));
  }
}

}  // namespace plumbline::gap
