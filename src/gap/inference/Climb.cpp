#include "gap/inference/Climb.h"

#include <algorithm>
#include <numeric>

#include "gap/inference/Visible.h"

namespace plumbline::gap {

namespace {

constexpr int climbSteps = 6, climbStepsLess = 2;  // of the one score: of a set, and with a cause less

}  // namespace

std::vector<std::size_t> idleCauses(const Replayer& replayer, const Explanation& causes) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < causes.size(); ++i)
    if (doesNothing(replayer.mechanism(), causes[i]) || !isVisible(replayer, causes, i)) found.push_back(i);
  return found;
}

std::size_t leastNeeded(const Replayer& replayer, const Scored& set) {
  std::vector<double> rest;
  for (std::size_t i = 0; i < set.causes().size(); ++i) {
    std::vector<Explanation> less = set.without;
    for (Explanation& causes : less) causes = without(causes, i);
    const std::vector<double> gains = gainsOf(replayer, without(set.causes(), i), less);
    rest.push_back(std::accumulate(gains.begin(), gains.end(), 0.0));
  }
  return static_cast<std::size_t>(std::ranges::max_element(rest) - rest.begin());
}

Scored climbed(const SearchTools& tools, const Explanation& start, std::size_t kinds) {
  const Replayer& replayer = *tools.coarse;
  const Shares shares = sharesOf(replayer.groups(), replayer.residuals(start));
  Scored best = score(replayer, shares, start, kinds, climbSteps);
  while (!best.causes().empty()) {
    const std::vector<std::size_t> idle = idleCauses(tools.replayer, best.causes());
    const std::size_t least = idle.empty() ? leastNeeded(replayer, best) : idle.front();
    Scored less = score(replayer, shares, without(best.causes(), least), kinds, climbStepsLess);
    if (idle.empty() && less.score() <= best.score()) break;
    best = std::move(less);
  }
  return best;
}

SetProposal withLessOne(const Replayer& replayer, Scored set, std::size_t kinds) {
  const Shares shares = sharesOf(replayer.groups(), replayer.residuals(set.causes()));
  SetProposal proposal{std::move(set), {}};
  const Explanation& causes = proposal.set.causes();
  for (std::size_t i = 0; i < causes.size(); ++i)
    proposal.lessOne.push_back(score(replayer, shares, without(causes, i), kinds, climbStepsLess));
  return proposal;
}

}  // namespace plumbline::gap
