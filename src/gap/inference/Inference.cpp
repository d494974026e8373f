#include "gap/inference/Inference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "gap/inference/Beam.h"
#include "gap/inference/CauseKinds.h"
#include "gap/inference/Interval.h"
#include "gap/inference/JointValues.h"
#include "gap/inference/LeaveOut.h"
#include "gap/inference/LeaveOutBias.h"
#include "gap/inference/Likelihood.h"
#include "gap/inference/Posterior.h"
#include "gap/inference/SetSearch.h"
#include "gap/inference/StoredParts.h"
#include "gap/inference/WindowReplayer.h"

namespace plumbline::gap {

namespace {

constexpr double leastRival = 0.01;  // probability of an alternative that is named

/// Pooled root mean square of the positions [rad, or m].
double positionsLeft(const Replayer& replayer, const Explanation& causes) {
  const Residuals residuals = replayer.residuals(causes);
  double sum = 0, n = 0;
  for (const Cell& cell : replayer.groups().cells()) {
    if (replayer.groups().trials()[cell.trial].signals[cell.signal].kind != SignalKind::position) continue;
    for (const double r : residualsOf(cell, residuals))
      if (std::isfinite(r)) sum += r * r, ++n;
  }
  return n > 0 ? std::sqrt(sum / n) : 0;
}

/// The discrepancy's amplitude over the noise, in the signal where it is largest: root of the mean over the
/// signal's cells.
struct Worst {
  double size = 0;
  std::string signal;
};
Worst worstOf(const Replayer& replayer, const Explanation& causes) {
  const Residuals residuals = replayer.residuals(causes);
  const Groups& groups = replayer.groups();
  std::map<std::string, std::pair<double, double>> sums;
  for (const Cell& cell : groups.cells()) {
    const std::vector<double> values = residualsOf(cell, residuals);
    if (values.empty()) continue;
    const double over = likeliestScale(values, cell.noise) / cell.noise;
    auto& [sum, n] = sums[groups.trials()[cell.trial].signals[cell.signal].name];
    sum += over * over - 1;
    ++n;
  }
  Worst worst;
  for (const auto& [name, of] : sums)
    if (const double size = std::sqrt(std::max(0.0, of.first / of.second)); size > worst.size)
      worst = {size, name};
  return worst;
}

/// The difference between repeats, in the same terms.
Worst worstOfRepeats(const Groups& groups) {
  Worst worst;
  for (std::size_t t = 0; t < groups.trials().size(); ++t)
    for (std::size_t s = 0; s < groups.uses()[t].size(); ++s) {
      const ChannelUse& use = groups.uses()[t][s];
      const double over = use.used ? use.noise / use.readingNoise : 1;
      if (const double size = std::sqrt(over * over - 1); size > worst.size)
        worst = {size, groups.trials()[t].signals[s].name};
    }
  return worst;
}

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

/// The only recording in which a cause gains; empty where several do, or stretches serve as recordings.
std::string onlySupport(const Groups& groups, const Scored& best, const Scored& lessOne) {
  if (groups.stretchesOfOne()) return "";
  std::vector<std::size_t> gaining;
  for (std::size_t g = 0; g < groups.count(); ++g)
    if (best.gain[g] > lessOne.gain[g]) gaining.push_back(g);
  if (gaining.size() != 1) return "";
  for (std::size_t t = 0; t < groups.trials().size(); ++t)
    if (groups.groupOf(t, 0) == gaining.front()) return groups.trials()[t].recording;
  return "";
}

std::vector<std::string> unused(const Groups& groups) {
  std::set<std::string> lines;
  const auto kind = [](const std::string& column) { return column.substr(0, column.find('.')); };
  for (std::size_t t = 0; t < groups.trials().size(); ++t) {
    for (const std::string& column : groups.trials()[t].notPredicted)
      lines.insert(kind(column) + ".* is not used: no model here predicts it");
    for (std::size_t s = 0; s < groups.uses()[t].size(); ++s) {
      const std::string& name = groups.trials()[t].signals[s].name;
      if (!groups.uses()[t][s].used) lines.insert(kind(name) + ".* is not used: " + groups.uses()[t][s].why);
    }
  }
  return {lines.begin(), lines.end()};
}

constexpr std::size_t mostOfManyKinds = 12;  // causes in a set of a robot with more

}  // namespace

void sortByEvidence(std::vector<Finding>& findings) {
  std::ranges::stable_sort(findings, std::ranges::greater(), &Finding::evidence);
}

Inference infer(const Mechanism& robot, std::vector<Trial> trials, const InferenceOptions& options) {
  const Groups groups(std::move(trials));
  const Replayer replayer(robot, groups, options.jobs);
  const auto report = [&](const char* stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  const bool fixedBase = std::ranges::none_of(groups.trials(), &Trial::freeBase),
             few = hasFewKinds(groups, robot);
  std::optional<WindowReplayer> windows;
  std::optional<Replayer> coarse;
  if (fixedBase && few) windows.emplace(robot, groups, options.jobs);
  if (fixedBase && !few) coarse.emplace(robot, groups, options.jobs, withLongSteps());
  const SearchTools tools{replayer, windows ? &*windows : nullptr, coarse ? &*coarse : nullptr};
  StoredParts parts(options.memory, [&] { return tools.numAsked(); });
  std::optional<CandidateScreening> screening;
  SetSearchOptions search;
  // The screening serves all searches, but takes long: where all are stored, nobody needs it.
  const auto searched = [&](const std::string& name, std::size_t count,
                            const std::function<BeamResult()>& run) {
    if (!screening && !parts.holdsSearch(name, count)) {
      parts.uncounted([&] {
        report("each cause alone", 0);
        screening.emplace(replayer, sharesOf(groups, replayer.residuals({})),
                          [&](double share) { report("each cause alone", share); });
      });
      search.screening = &*screening;
    }
    return parts.search(name, count, run);
  };
  if (!few) search.mostCauses = mostOfManyKinds;
  if (options.mostCauses > 0) search.mostCauses = options.mostCauses;
  search.progress = [&](double share) { report("sets of causes", share); };
  const std::string setsOfCauses = "sets of causes";
  const BeamResult found =
      searched(setsOfCauses, groups.count(), [&] { return searchForSets(tools, search); });
  const Scored& best = found.sets.front();
  const std::vector<double> p = posterior(found.sets);
  search.expectMany = coarse && best.causes().size() > mostSetBySet;
  search.progress = [&](double share) { report("again without each recording in turn", share); };
  std::vector<FoundWithout> without =
      findWithoutEach(tools, search, [&](std::size_t g, std::size_t left, const auto& run) {
        return searched(setsOfCauses + nameWithout(g), left, run);
      });

  Inference result;
  result.stretchesOfOne = groups.stretchesOfOne();
  result.notUsed = unused(groups);
  for (const auto& uses : groups.uses()) {
    auto& of = result.noises.emplace_back();
    for (const ChannelUse& use : uses) of.push_back({use.noise, use.noise, false});
  }
  Diagnosis& diagnosis = result.diagnosis;
  const double nominal = positionsLeft(replayer, {}), all = positionsLeft(replayer, best.causes());
  const std::vector<Bounds> intervals = intervalsOf(replayer, best);
  for (std::size_t i = 0; i < best.causes().size(); ++i) {
    Finding finding;
    finding.cause = best.causes()[i];
    finding.lower = intervals[i].lower;
    finding.upper = intervals[i].upper;
    finding.probability = probabilityIn(finding.cause, found.sets, p, without);
    finding.closedAlone = 1 - positionsLeft(replayer, {finding.cause}) / nominal;
    finding.closedLast = (positionsLeft(replayer, gap::without(best.causes(), i)) - all) / nominal;
    finding.evidence = best.score() - found.lessOne[i].score();
    finding.rivals = rivalsOf(found.sets, p, i);
    diagnosis.findings.push_back(std::move(finding));
    if (const std::string only = onlySupport(groups, best, found.lessOne[i]); !only.empty())
      result.onlyIn.push_back(describe(best.causes()[i]) + " is supported by " + only + " alone");
  }
  sortByEvidence(diagnosis.findings);
  const Worst before = worstOf(replayer, {}), after = worstOf(replayer, best.causes());
  diagnosis.worstBefore = before.size;
  diagnosis.worstSignal = before.signal;
  diagnosis.worstAfter = after.size;
  diagnosis.worstSignalAfter = after.signal;
  const Worst repeats = worstOfRepeats(groups);
  result.repeatsDiffer = repeats.size;
  result.repeatsSignal = repeats.signal;
  const double beyond = best.causes().empty() ? std::max(after.size, repeats.size) : after.size;
  diagnosis.verdict = beyond > leastUnexplained ? Verdict::unknown
                      : best.causes().empty()   ? Verdict::none
                                                : Verdict::effect;
  diagnosis.knownProbability = 1 / (1 + beyond * beyond);
  for (const FoundWithout& of : without) result.foundWithout.push_back(of.causes);
  // If the causes explain everything, their values are right.
  if (diagnosis.verdict == Verdict::unknown && fixedBase && differsByJoint(robot, best.causes())) {
    const Replayer& quick = coarse ? *coarse : replayer;
    const std::string inEachJoint = "values in each joint";
    const auto reportFits = [&](std::size_t done) {
      report(inEachJoint.c_str(), static_cast<double>(done) / static_cast<double>(without.size() + 1));
    };
    for (std::size_t g = 0; g < without.size(); ++g) {
      reportFits(g);
      const Groups others = groups.without(g);
      without[g].causes = parts.values(inEachJoint + nameWithout(g), [&] {
        return withJointValues(Replayer(quick, others), without[g].causes);
      });
    }
    reportFits(without.size());
    diagnosis.jointValues = parts.values(inEachJoint, [&] { return withJointValues(quick, best.causes()); });
  }
  report("recordings left out", 0);
  result.leftOut = leftWithout(groups, without);
  result.claim = claimOf(
      closedPerGroup(result.leftOut, groupsOfRecordings(groups)),
      leaveOutBias(groups, diagnosis.jointValues.empty() ? best.causes() : diagnosis.jointValues, without));
  double squaresBefore = 0, squaresAfter = 0, squaresFloor = 0;
  const auto count = static_cast<double>(result.leftOut.size());
  for (const RecordingLeft& recording : result.leftOut) {
    squaresBefore += recording.before * recording.before / count;
    squaresAfter += recording.after * recording.after / count;
    squaresFloor += recording.floor * recording.floor / count;
  }
  diagnosis.gap = {std::sqrt(squaresBefore), std::sqrt(squaresAfter), std::sqrt(squaresFloor)};
  result.replays = parts.replays();
  return result;
}

}  // namespace plumbline::gap
