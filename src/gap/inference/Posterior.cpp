#include "gap/inference/Posterior.h"

#include <algorithm>
#include <cmath>

#include "math/Random.h"

namespace plumbline::gap {

std::vector<double> posterior(const std::vector<Scored>& sets, std::uint64_t seed) {
  constexpr int draws = 400;
  std::vector<double> sum(sets.size(), 0.0);
  if (sets.empty()) return sum;
  Random random(seed);
  const std::size_t groups = sets.front().gain.size();
  std::vector<double> weight(groups), score(sets.size());
  for (int draw = 0; draw < draws; ++draw) {
    double total = 0;
    for (double& w : weight) total += w = -std::log(1 - random.uniform());
    for (double& w : weight) w *= static_cast<double>(groups) / total;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      score[i] = -sets[i].price;
      for (std::size_t g = 0; g < groups; ++g) score[i] += weight[g] * sets[i].gain[g];
    }
    const double best = *std::ranges::max_element(score);
    double all = 0;
    for (double& s : score) all += s = std::exp(s - best);
    for (std::size_t i = 0; i < sets.size(); ++i) sum[i] += score[i] / all / draws;
  }
  return sum;
}

double probabilityOf(const Cause& cause, const std::vector<Scored>& sets, const std::vector<double>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (std::ranges::any_of(sets[i].causes(), [&](const Cause& c) { return c.sameKind(cause); })) sum += p[i];
  return std::min(1.0, sum);
}

}  // namespace plumbline::gap
