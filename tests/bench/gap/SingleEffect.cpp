#include "SingleEffect.h"

#include <algorithm>
#include <cmath>

#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/PossibleCauses.h"

namespace plumbline::bench {

using namespace gap;

Explanation bestByBic(Evaluator& fine, Evaluator& coarse, int jobs) {
  fine.setBase({});
  coarse.setBase({});
  const Evidence& evidence = fine.evidence();
  double samples = 0;
  for (std::size_t t = 0; t < evidence.trials().size(); ++t)
    for (std::size_t s = 0; s < evidence.trials()[t].signals.size(); ++s)
      samples +=
          static_cast<double>(std::ranges::count_if(evidence.weights(t, s), [](double w) { return w > 0; }));
  SearchOptions options;
  options.jobs = jobs;
  Explanation best;
  double least = fine.baseFit().fitting - std::log(std::max(2.0, samples / 2));
  for (const FittedCause& candidate : search(fine, coarse, possibleCauses(fine), options))
    if (candidate.fit.fitting < least) least = candidate.fit.fitting, best = {candidate.cause};
  return best;
}

Explanation oracle(const BlindCase& c, Evaluator& fine, Evaluator& coarse, int jobs) {
  SearchOptions options;
  options.jobs = jobs;
  Explanation known;
  for (const BlindEffect& truth : c.effects) {
    fine.setBase(known);
    coarse.setBase(known);
    std::vector<Cause> causes = possibleCauses(fine);
    std::erase_if(causes, [&](const Cause& cause) { return cause.effect->id != truth.effect; });
    const std::vector<FittedCause> list = search(fine, coarse, causes, options);
    if (!list.empty()) known.push_back(list.front().cause);
  }
  return known;
}

}  // namespace plumbline::bench
