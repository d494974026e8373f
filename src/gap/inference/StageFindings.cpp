#include "gap/inference/StageFindings.h"

#include <algorithm>

#include "gap/diagnosis/Noise.h"
#include "gap/inference/Interval.h"
#include "gap/inference/Posterior.h"

namespace plumbline::gap {

namespace {

constexpr double leastRival = 0.01;  // probability of an alternative that is named

std::vector<Rival> rivalsOf(const std::vector<Scored>& sets, const std::vector<double>& p, std::size_t i) {
  const Explanation& best = sets.front().causes();
  std::vector<Rival> rivals;
  for (std::size_t other = 1; other < sets.size(); ++other) {
    const Explanation& causes = sets[other].causes();
    const auto holds = [](const Explanation& set, const Cause& cause) {
      return std::ranges::any_of(set, [&](const Cause& c) { return c.sameKind(cause); });
    };
    if (holds(causes, best[i])) continue;
    for (const Cause& cause : causes) {
      if (holds(best, cause)) continue;
      const auto known =
          std::ranges::find_if(rivals, [&](const Rival& r) { return r.cause.sameKind(cause); });
      if (known == rivals.end())
        rivals.push_back({cause, p[other]});
      else
        known->probability += p[other];
    }
  }
  std::erase_if(rivals, [](const Rival& rival) { return rival.probability < leastRival; });
  std::ranges::stable_sort(rivals, std::ranges::greater(), &Rival::probability);
  return rivals;
}

/// Mean over the search in all groups and those without one: a cause that only a few recordings support is
/// not sure. This is a posterior averaged over data sets (Huggins and Miller, "Reproducible model selection
/// using bagged posteriors", Bayesian Analysis 18, 2023).
double probabilityIn(const Cause& cause, const std::vector<Scored>& sets, const std::vector<double>& p,
                     const std::vector<FoundWithout>& without) {
  double sum = probabilityOf(cause, sets, p);
  for (const FoundWithout& found : without) sum += probabilityOf(cause, found.sets, found.probabilities);
  return sum / static_cast<double>(without.size() + 1);
}

/// The only recording in which a cause gains; empty where several do, where stretches serve as recordings, or
/// where a group is of several motions.
std::string onlySupport(const Groups& groups, const Scored& best, const Scored& lessOne) {
  if (groups.stretchesOfOne()) return "";
  std::vector<std::size_t> gaining;
  for (std::size_t g = 0; g < groups.count(); ++g)
    if (best.gain[g] > lessOne.gain[g]) gaining.push_back(g);
  if (gaining.size() != 1) return "";
  const Trial* only = nullptr;
  for (std::size_t t = 0; t < groups.trials().size(); ++t) {
    const Trial& trial = groups.trials()[t];
    if (groups.groupOf(t, 0) != gaining.front()) continue;
    if (only && only->recording != trial.recording && !isRepeat(*only, trial)) return "";
    if (!only) only = &trial;
  }
  return only ? only->recording : "";
}

}  // namespace

std::vector<Finding> findingsOf(const SearchStage& stage) {
  const Scored& best = stage.best();
  const std::vector<Bounds> intervals = intervalsOf(stage.replayer, best);
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < best.causes().size(); ++i) {
    Finding& finding = findings.emplace_back();
    finding.cause = best.causes()[i];
    finding.lower = intervals[i].lower;
    finding.upper = intervals[i].upper;
    finding.probability = probabilityIn(finding.cause, stage.found.sets, stage.probabilities, stage.without);
    finding.evidence = best.score() - stage.found.lessOne[i].score();
    finding.rivals = rivalsOf(stage.found.sets, stage.probabilities, i);
  }
  return findings;
}

std::vector<std::string> supportedByOne(const SearchStage& stage) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < stage.best().causes().size(); ++i)
    if (const std::string only = onlySupport(stage.groups, stage.best(), stage.found.lessOne[i]);
        !only.empty())
      lines.push_back(describe(stage.best().causes()[i]) + " is supported by " + only + " alone");
  return lines;
}

}  // namespace plumbline::gap
