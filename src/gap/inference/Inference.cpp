#include "gap/inference/Inference.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gap/diagnosis/UnusedColumns.h"
#include "gap/inference/JointValues.h"
#include "gap/inference/LeaveOutBias.h"
#include "gap/inference/SearchRounds.h"
#include "gap/inference/StageFindings.h"
#include "gap/inference/StoredParts.h"
#include "gap/inference/Unexplained.h"

namespace plumbline::gap {

namespace {

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

/// The difference between repeats, in the terms of worstOf.
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

/// Lost commands as a finding; not what they close.
Finding findingOf(const CommandLosses& lost) {
  Finding finding;
  finding.cause = CommandLosses::cause(lost.share());
  const Bounds interval = lost.interval();
  finding.lower = interval.lower;
  finding.upper = interval.upper;
  finding.probability = 1 / (1 + std::exp(-lost.evidence));
  finding.evidence = lost.evidence;
  return finding;
}

/// Adds their share in the other groups to what is found without a group. Which commands a recording lost is
/// not known before it was made, so none is taken as known there.
void addLost(const CommandLosses& lost, const Groups& groups, std::vector<FoundWithout>& found) {
  for (std::size_t g = 0; g < found.size(); ++g) {
    std::vector<char> others;
    for (std::size_t t = 0; t < groups.trials().size() && !groups.stretchesOfOne(); ++t)
      others.push_back(!groups.holds(g, t));
    if (const double share = lost.share(others); share > 0)
      found[g].causes.push_back(CommandLosses::cause(share));
  }
}

std::vector<std::string> unused(const Groups& groups) {
  return unusedColumns(groups.trials(), [&](std::size_t t, std::size_t s) {
    const ChannelUse& use = groups.uses()[t][s];
    return use.used ? "" : use.why;
  });
}

}  // namespace

void sortByEvidence(std::vector<Finding>& findings) {
  std::ranges::stable_sort(findings, std::ranges::greater(), &Finding::evidence);
}

Inference infer(const Mechanism& robot, std::vector<Trial> trials, const InferenceOptions& options) {
  SearchRounds rounds(robot, std::move(trials), options);
  const auto report = [&](const char* stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  StoredParts parts(options.memory, [&] { return rounds.numAsked(); });
  rounds.run(parts);
  const StagedSearch& search = rounds.last().search;
  const Groups& groups = rounds.last().groups;
  const Replayer& replayer = rounds.last().replayer;
  const bool fixedBase = std::ranges::none_of(groups.trials(), &Trial::freeBase);
  const Explanation causes = search.causes();
  std::vector<FoundWithout> without = search.withoutEach();

  Inference result;
  result.stretchesOfOne = groups.stretchesOfOne();
  result.notUsed = unused(groups);
  for (const auto& uses : groups.uses()) {
    auto& of = result.noises.emplace_back();
    for (const ChannelUse& use : uses) of.push_back({use.noise, use.noise, false});
  }
  Diagnosis& diagnosis = result.diagnosis;
  std::optional<Replayer> withoutLosses;
  if (rounds.lost().any()) {
    ReplayOptions commandsAsSent;
    commandsAsSent.asSent = true;
    withoutLosses.emplace(robot, groups, options.jobs, commandsAsSent);
  }
  const Replayer& asSent = withoutLosses ? *withoutLosses : replayer;
  const double nominal = positionsLeft(asSent, {}), all = positionsLeft(replayer, causes);
  for (const auto& stage : search.stages()) {
    for (Finding& finding : findingsOf(*stage)) {
      const std::size_t i = diagnosis.findings.size();  // causes are in the same order
      finding.closedAlone = 1 - positionsLeft(asSent, {finding.cause}) / nominal;
      finding.closedLast = (positionsLeft(replayer, gap::without(causes, i)) - all) / nominal;
      diagnosis.findings.push_back(std::move(finding));
    }
    for (std::string& line : supportedByOne(*stage)) result.onlyIn.push_back(std::move(line));
  }
  result.lost = rounds.lost();
  if (result.lost.any()) {
    Finding& finding = diagnosis.findings.emplace_back(findingOf(result.lost));
    finding.closedAlone = 1 - positionsLeft(replayer, {}) / nominal;
    finding.closedLast = (positionsLeft(asSent, causes) - all) / nominal;
  }
  sortByEvidence(diagnosis.findings);
  const Worst before = worstOf(asSent, {}), after = worstOf(replayer, causes);
  diagnosis.worstBefore = before.size;
  diagnosis.worstSignal = before.signal;
  diagnosis.worstAfter = after.size;
  diagnosis.worstSignalAfter = after.signal;
  const Worst repeats = worstOfRepeats(groups);
  result.repeatsDiffer = repeats.size;
  result.repeatsSignal = repeats.signal;
  result.bound = after.bound;
  const bool none = diagnosis.findings.empty();
  const double beyond = none ? std::max(after.share(), repeats.share()) : after.share();
  diagnosis.verdict = beyond > 1 ? Verdict::unknown : none ? Verdict::none : Verdict::effect;
  diagnosis.knownProbability = 1 / (1 + beyond * beyond);
  // If the causes explain everything, their values are right.
  if (diagnosis.verdict == Verdict::unknown && fixedBase && differsByJoint(robot, causes)) {
    const Replayer& quick = search.coarse() ? *search.coarse() : replayer;
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
    diagnosis.jointValues = parts.values(inEachJoint, [&] { return withJointValues(quick, causes); });
  }
  report("recordings left out", 0);
  Explanation model = diagnosis.jointValues.empty() ? causes : diagnosis.jointValues;
  if (result.lost.any()) {
    addLost(result.lost, groups, without);
    model.push_back(CommandLosses::cause(result.lost.share()));
    if (!diagnosis.jointValues.empty()) diagnosis.jointValues = model;
  }
  for (const FoundWithout& of : without) result.foundWithout.push_back(of.causes);
  result.leftOut = leftWithout(rounds.sent(), without);
  result.claim = claimOf(closedPerGroup(result.leftOut, groupsOfRecordings(groups)),
                         leaveOutBias(rounds.sent(), model, without));
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
