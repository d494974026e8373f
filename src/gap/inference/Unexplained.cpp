#include "gap/inference/Unexplained.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "gap/inference/Density.h"
#include "gap/inference/Likelihood.h"

namespace plumbline::gap {

Worst worstOf(const Replayer& replayer, const Explanation& causes, double onFeet) {
  const Residuals residuals = replayer.residuals(causes);
  const Groups& groups = replayer.groups();
  std::map<std::pair<std::string, bool>, std::pair<double, double>> sums;
  for (const Cell& cell : groups.cells()) {
    const std::vector<double> values = residualsOf(cell, residuals);
    if (values.empty()) continue;
    const Trial& trial = groups.trials()[cell.trial];
    const double over = likeliestScale(values, cell.noise) / cell.noise;
    auto& [sum, n] = sums[{trial.signals[cell.signal].name, trial.freeBase}];
    sum += over * over - 1;
    ++n;
  }
  Worst worst;
  for (const auto& [of, sum] : sums) {
    const Worst here{std::sqrt(std::max(0.0, sum.first / sum.second)), of.first,
                     of.second ? onFeet : leastUnexplained};
    if (here.share() > worst.share()) worst = here;
  }
  return worst;
}

}  // namespace plumbline::gap
