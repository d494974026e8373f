#include "gap/inference/Inference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "gap/inference/Beam.h"
#include "gap/inference/Likelihood.h"
#include "gap/inference/Posterior.h"

namespace plumbline::gap {

namespace {

constexpr double leastRival = 0.01;  // probability of what is named beside
constexpr double unexplained = 1;    // discrepancy over noise beyond which the library lacks something

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

/// Each recording replayed with the values that were fitted without it.
std::vector<RecordingLeft> leaveOut(const Groups& groups, const Scored& best) {
  std::map<std::string, std::vector<RecordingLeft>> parts;
  std::vector<std::string> order;
  for (std::size_t t = 0; t < groups.trials().size(); ++t) {
    const Trial& trial = groups.trials()[t];
    std::vector<From> causes;
    for (std::size_t k = 0; k < trial.cycles(); ++k) {
      const std::size_t group = groups.groupOf(t, k);
      if (k == 0 || group != groups.groupOf(t, k - 1)) causes.push_back({k, best.without[group]});
    }
    if (!parts.contains(trial.recording)) order.push_back(trial.recording);
    parts[trial.recording].push_back(leftIn(trial, causes));
  }
  std::vector<RecordingLeft> left;
  for (const std::string& folder : order) left.push_back(together(parts[folder]));
  putFloors(groups.trials(), left);
  return left;
}

std::vector<std::string> unused(const Groups& groups) {
  std::set<std::string> lines;
  for (std::size_t t = 0; t < groups.trials().size(); ++t)
    for (std::size_t s = 0; s < groups.uses()[t].size(); ++s) {
      const std::string& name = groups.trials()[t].signals[s].name;
      if (!groups.uses()[t][s].used)
        lines.insert(name.substr(0, name.find('.')) + ".* is not used: " + groups.uses()[t][s].why);
    }
  return {lines.begin(), lines.end()};
}

}  // namespace

Inference infer(const Mechanism& robot, std::vector<Trial> trials, const InferenceOptions& options) {
  const Groups groups(std::move(trials));
  const Replayer replayer(robot, groups, options.jobs);
  BeamOptions beam;
  beam.mostCauses = options.mostCauses;
  beam.progress = options.progress;
  const BeamResult found = searchSets(replayer, beam);
  const Scored& best = found.sets.front();
  const std::vector<double> p = posterior(found.sets);

  Inference result;
  result.stretchesOfOne = groups.stretchesOfOne();
  result.notUsed = unused(groups);
  for (const auto& uses : groups.uses()) {
    auto& of = result.noises.emplace_back();
    for (const ChannelUse& use : uses) of.push_back({use.noise, use.noise, false});
  }
  Diagnosis& diagnosis = result.diagnosis;
  const double nominal = positionsLeft(replayer, {}), all = positionsLeft(replayer, best.causes());
  for (std::size_t i = 0; i < best.causes().size(); ++i) {
    Finding finding;
    finding.cause = best.causes()[i];
    const Bounds interval = intervalOf(best, i, robot);
    finding.lower = interval.lower;
    finding.upper = interval.upper;
    finding.probability = probabilityOf(finding.cause, found.sets, p);
    finding.closedAlone = 1 - positionsLeft(replayer, {finding.cause}) / nominal;
    finding.closedLast = (positionsLeft(replayer, without(best.causes(), i)) - all) / nominal;
    finding.rivals = rivalsOf(found.sets, p, i);
    diagnosis.findings.push_back(std::move(finding));
  }
  std::ranges::stable_sort(diagnosis.findings, std::ranges::greater(), &Finding::closedLast);
  const Worst before = worstOf(replayer, {}), after = worstOf(replayer, best.causes());
  diagnosis.worstBefore = before.size;
  diagnosis.worstSignal = before.signal;
  diagnosis.worstAfter = after.size;
  diagnosis.worstSignalAfter = after.signal;
  const bool left = after.size > unexplained;
  diagnosis.verdict = left ? Verdict::unknown : best.causes().empty() ? Verdict::none : Verdict::effect;
  diagnosis.knownProbability = 1 / (1 + after.size * after.size);
  result.leftOut = leaveOut(groups, best);
  diagnosis.gap = {0, 0, 0};
  double squaresBefore = 0, squaresAfter = 0, squaresFloor = 0;
  const auto count = static_cast<double>(result.leftOut.size());
  for (const RecordingLeft& recording : result.leftOut) {
    squaresBefore += recording.before * recording.before / count;
    squaresAfter += recording.after * recording.after / count;
    squaresFloor += recording.floor * recording.floor / count;
  }
  diagnosis.gap = {std::sqrt(squaresBefore), std::sqrt(squaresAfter), std::sqrt(squaresFloor)};
  result.replays = replayer.numReplays();
  return result;
}

std::string Inference::sentence() const {
  char text[256];
  if (diagnosis.verdict == Verdict::none) {
    std::snprintf(text, sizeof text,
                  "The nominal model explains these runs down to their noise (worst channel %.1f times the "
                  "noise beyond it).",
                  diagnosis.worstBefore);
    return text;
  }
  std::string causes;
  for (const Finding& finding : diagnosis.findings) {
    std::snprintf(text, sizeof text, " (%.0f %%)", 100 * finding.probability);
    causes += (causes.empty() ? "" : ", ") + describe(finding.cause) + text;
  }
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const RecordingLeft& left : leftOut) {
    least = std::min(least, left.closed());
    most = std::max(most, left.closed());
  }
  std::string claim = stretchesOfOne
                          ? "Of the gap in stretches of the one recording that took no part in the fit "
                          : "Of the gap in recordings that took no part in the fit ";
  std::snprintf(text, sizeof text, "it closes %.0f %% (%.0f to %.0f %% in each).", 100 * closed(),
                100 * least, 100 * most);
  claim += text;
  if (diagnosis.verdict == Verdict::effect) return "Missing from the model: " + causes + ". " + claim;
  std::snprintf(text, sizeof text,
                "More is missing than the library's effects account for: %.1f times the noise remain in %s.",
                diagnosis.worstAfter, diagnosis.worstSignalAfter.c_str());
  if (causes.empty()) return text;
  return text + (" The nearest explanation is " + causes + ". ") + claim;
}

}  // namespace plumbline::gap
