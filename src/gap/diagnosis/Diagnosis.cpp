#include "gap/diagnosis/Diagnosis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/diagnosis/AcrossSettings.h"
#include "gap/diagnosis/FindingOf.h"
#include "gap/diagnosis/GapMeter.h"
#include "gap/diagnosis/Merit.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/Probability.h"
#include "gap/diagnosis/Proposals.h"
#include "gap/diagnosis/Remainder.h"
#include "gap/diagnosis/Search.h"
#include "gap/diagnosis/SharedCauses.h"
#include "gap/diagnosis/Suspects.h"

namespace plumbline::gap {

namespace {

// Gaps beyond noise, of the worst channel, in units of its noise.
constexpr double present = 0.9;  // below that nothing is looked for
// The same over what may remain, at most, of runs on the feet where held ones are explained: a joint that
// sticks lets go a moment too late there and leads the rest astray.
constexpr double heldExplained = 0.9;
constexpr double crowded = 0.25;     // more of what remains counts for each further cause at one joint
constexpr double heldOffset = 0.15;  // mean of a sensor at rest over its noise, that no cause may leave
constexpr double farOff = 3;         // times what may remain: no set of causes is worth another look

// Where only a little of the gap is left (Remainder::little), a further cause has to explain
// most of that, and to be more probable than all others together.
constexpr double mostOfIt = 0.6, surer = 0.5;
constexpr double hopeless = 0.3;    // of the best candidate's gain lost: not tried as a further cause
constexpr double otherStart = 0.7;  // of the best first cause's gain: what gains less is no other start
constexpr std::size_t tries = 3, otherStarts = 3;
constexpr double surelyLess = 0.95;  // of the error across settings: another set is not worth it
constexpr int evaluations = 32;      // of values that are fitted together

class Procedure {
public:
  Procedure(Evaluator& fine_, Evaluator& coarse_, const DiagnosisOptions& options_)
      : fine(fine_),
        coarse(coarse_),
        options(options_),
        proposals(fine_, coarse_, options_),
        meter((fine_.setBase({}), fine_)) {}

  Diagnosis run() {
    const WorstGap worst = worstGap(fine);
    result.worstBefore = worst.size;
    result.worstSignal = worst.signal;
    result.gap.before = meter.under(fine);
    double remainsHeld = 0;
    if (fine.hasHeld() && fine.hasStanding() && heldRunsTell(fine)) remainsHeld = explainHeldRuns();
    const bool heldTold = !found.empty();
    if (remainsHeld > 1) {
      // Not known to the library. What came nearest on held runs may topple the robot.
      if (meter.under(fine) > result.gap.before) forget();
    } else if (found.empty()) {
      explain();
    } else {
      grow();
    }
    acrossSettings();
    lookForRivals();
    const WorstGap left = worstGap(fine);
    result.worstAfter = left.size;
    result.worstSignalAfter = left.signal;
    result.gap.after = meter.under(fine);
    judge(remainsHeld, heldTold);
    return result;
  }

private:
  using Candidates = std::vector<Candidate>;

  void forget() {
    found.clear();
    choices.clear();
    fine.setBase({});
  }

  /// From nothing to the set of causes that predicts best.
  void explain() {
    const double nominal = fine.baseFit().judging;
    grow();
    beginOtherwise(nominal);
    if (found.size() > 1 && remainder().mayRemain(farOff)) reconsider();
  }

  /// Where held runs show what is wrong, they tell it for a hundredth of the price; what remains of them over
  /// what may remain. On the feet only what is found is then looked at, and what those runs show besides.
  double explainHeldRuns() {
    for (Evaluator* evaluator : {&fine, &coarse}) evaluator->leaveStandingOut(true);
    const double whole = std::exchange(result.worstBefore, worstGap(fine).size);
    onHeldRuns = true;
    explain();
    fine.setBase(found);
    const double remains = worstGap(fine).size < unexplained ? 0 : remainder().unaccounted();
    onHeldRuns = false;
    result.worstBefore = whole;
    for (Evaluator* evaluator : {&fine, &coarse}) evaluator->leaveStandingOut(false);
    fine.setBase(found);
    return remains;
  }

  /// What could be added to the base, most probable first.
  Candidates candidates(const std::string& stage, bool onlySensors = false) {
    return proposals.find({.stage = stage,
                           .leastGain = leastPart() / 2 * std::max(0.0, excess(fine)),
                           .onlySensors = onlySensors,
                           .lostCommands = !lostCommandsLast,
                           .memory = wholeMemory()});
  }

  /// Tries the best candidates on top of the base, values that depend on each other fitted together; keeps
  /// the one that predicts best of those that earn their place.
  bool accept(const Candidates& list) {
    if (list.empty()) return false;
    const Standing before(fine);
    const double part = leastPart();
    // Where little is left, a cause that is less probable than all others together is a guess.
    if (part > 0 && probabilities(list).front() < surer) return false;
    const Explanation old = fine.base();
    const double front = list.front().fit.judging, least = front + hopeless * (before.judging() - front);
    Explanation best;
    double bestJudging = INFINITY;
    for (std::size_t i = 0; i < std::min(old.empty() ? 1 : tries, list.size()); ++i) {
      if (list[i].fit.judging > least) break;
      Explanation tried = old;
      tried.push_back(list[i].cause);
      fine.setBase(old);
      const Explanation together =
          ofSensor(list[i].cause) ? tried
                                  : fitTogether(proposals.quickOn(old), tried, evaluations, options.jobs);
      const bool better = together == tried || fine.of(together).fitting < fine.of(tried).fitting;
      fine.setBase(better ? together : tried);
      if (fine.baseFit().judging < bestJudging && before.betteredBy(fine, part)) {
        best = fine.base();
        bestJudging = fine.baseFit().judging;
      }
    }
    fine.setBase(best.empty() ? old : best);
    return !best.empty();
  }

  /// The share of what is unexplained that a further cause has to explain: where little is left of a large
  /// gap, that may be what the effects found do otherwise in reality, and only what explains most of it
  /// counts.
  double leastPart() const { return !fine.base().empty() && remainder().little() ? mostOfIt : 0; }
  Remainder remainder() const { return {fine, result.worstBefore}; }

  /// Adds causes from the base on until none earns its place. most: sum of squares for judging above which
  /// two causes are not worth a third.
  void grow(double most = INFINITY) {
    while (found.size() < options.maxCauses &&
           (found.empty() ? worstGap(fine).size >= present : remainder().size() >= unexplained)) {
      if (found.size() > 1 && fine.baseFit().judging > most) break;
      Candidates list = candidates(found.empty() ? "first cause" : "further cause",
                                   !found.empty() && remainder().onlyOfSensors());
      if (!accept(list)) {
        if (choices.empty()) choices.push_back(std::move(list));
        break;
      }
      found = fine.base();
      choices.push_back(std::move(list));
    }
  }

  /// Where much stays unexplained, the first cause may have been the wrong one: begins with others, keeps the
  /// set that predicts best.
  void beginOtherwise(double nominal) {
    if (choices.empty() || remainder().mayRemain() || beginShared()) return;
    // Looking again on the feet takes minutes.
    if (fine.hasStanding() && !found.empty() && remainder().unaccounted() <= 1) return;
    const Candidates firsts = choices.front();
    if (found.empty()) choices.clear();
    Explanation best = found;
    std::vector<Candidates> bestChoices = choices;
    double bestJudging = fine.baseFit().judging;
    for (std::size_t i = 1; i < std::min(firsts.size(), 1 + otherStarts); ++i) {
      if (nominal - firsts[i].fit.judging < otherStart * (nominal - firsts.front().fit.judging)) break;
      found = {firsts[i].cause};
      choices = {firsts};
      fine.setBase(found);
      grow(bestJudging);
      if (fine.baseFit().judging < bestJudging - leastGain && found.size() > 1) {
        best = found;
        bestChoices = choices;
        bestJudging = fine.baseFit().judging;
      }
    }
    found = std::move(best);
    choices = std::move(bestChoices);
    fine.setBase(found);
  }

  /// Where all servos are of one type: begins with what they share, chosen together. Whether that took the
  /// place of what was found.
  bool beginShared() {
    if (!fine.mechanism().sharesServo() || fine.hasStanding()) return false;
    const Explanation old = found;
    fine.setBase({});
    const Explanation set = sharedCauses(fine, options.maxCauses, options.jobs, [&](double share) {
      if (options.progress) options.progress("what servos share", share);
    });
    if (set.empty()) {
      fine.setBase(old);
      return false;
    }
    std::vector<Candidates> kept = std::exchange(choices, std::vector<Candidates>(set.size()));
    found = set;
    fine.setBase(found);
    // Lost commands are told cycle by cycle, which takes in much of whatever else is missing.
    lostCommandsLast = true;
    grow();
    if (options.progress) options.progress("each motion from the others", 0);
    const Explanation chosen = betterAcrossMotions(fine, found, old, options.jobs);
    const bool better = chosen != old;
    found = chosen;
    fine.setBase(found);
    if (better) {
      grow();
    } else {
      choices = std::move(kept);
    }
    lostCommandsLast = better;
    if (better) addLostIfNothingRemains();
    return better;
  }

  void addLostIfNothingRemains() {
    Candidates lost;
    if (found.size() < options.maxCauses && !remainder().mayRemain()) proposals.addLostCommands(lost);
    if (lost.empty()) return;
    found.push_back(lost.front().cause);
    fine.setBase(found);
    if (remainder().mayRemain()) {
      choices.push_back(std::move(lost));
      lostCommandsLast = false;
    } else {
      found.pop_back();
      fine.setBase(found);
    }
  }

  /// Each cause once more with the others in place: another may do better now, or it may not be needed.
  void reconsider() {
    for (std::size_t i = 0; i < found.size();) {
      fine.setBase(found);
      const double whole = fine.baseFit().judging;
      fine.setBase(without(found, i));
      if (fine.baseFit().judging - whole < leastGain) {
        found = fine.base();
        choices.erase(choices.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      choices[i] = candidates("each cause again");
      if (!choices[i].empty() && choices[i].front().fit.judging < whole - leastGain)
        found[i] = choices[i].front().cause;
      ++i;
    }
    fine.setBase(found);
    found = fitTogether(fine, found, evaluations, options.jobs);
  }

  /// Where runs were recorded under several servo settings and something remains: the set of causes that
  /// predicts each setting from the others best, if it does better than what was found.
  void acrossSettings() {
    if (found.empty() || fine.hasStanding() || remainder().size() < unexplained) return;
    const AcrossSettings settings(fine.mechanism(), fine.evidence(), options.jobs);
    if (!settings.possible()) return;
    const AcrossSettings quick(fine.mechanism(), fine.evidence(), options.jobs, coarseSteps());
    fine.setBase({});
    const std::vector<Cause> starts = startsAcross(fine);
    const Explanation set = quick
                                .best(starts, options.maxCauses,
                                      [&](double share) {
                                        if (options.progress) options.progress("across settings", share);
                                      })
                                .causes;
    const AcrossSettings::Tried best = settings.of(set);
    if (best.error < surelyLess * settings.of(found).error) {
      found = best.causes;
      choices.assign(found.size(), {});
      heldAcross = true;
    }
  }

  /// What stood for choice besides causes that were chosen together.
  void lookForRivals() {
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!choices[i].empty()) continue;
      fine.setBase(without(found, i));
      choices[i] = withItself(candidates("each cause again"), found[i]);
    }
    fine.setBase(found);
  }

  /// What stood for choice besides a cause that was chosen otherwise; its value fitted like theirs.
  Candidates withItself(Candidates list, const Cause& cause) {
    std::erase_if(list, [&](const Candidate& c) { return c.cause.sameKind(cause); });
    list.push_back(fitValue(fine, cause, {}));
    sortByProbability(list);
    return list;
  }

  void judge(double remainsHeld, bool heldTold) {
    // What another engine does otherwise may be left of a large gap.
    const Remainder left = remainder();
    double onFeet = left.unaccountedOnFeet();
    if (heldTold && remainsHeld <= 1) onFeet = std::min(onFeet, heldExplained);
    // What predicts a setting that it was not fitted to is not put together for the others.
    const int together = heldAcross ? 1 : mostAtOneJoint(found);
    double remains = std::max({left.unaccountedHeld(), onFeet, remainsHeld}) * (1 + crowded * (together - 1));
    const WorstGap sensor = worstHeldOffset(fine);
    if (sensor.size > heldOffset) {
      result.sensorOff = sensor.signal;
      result.sensorOffBy = sensor.size;
    }
    remains = std::max(remains, sensor.size / heldOffset);
    result.knownProbability = 1 / (1 + std::exp(6 * (remains - 1)));
    if (found.empty()) {
      result.verdict = result.worstBefore < unexplained ? Verdict::none : Verdict::unknown;
    } else {
      result.verdict = remains > 1 ? Verdict::unknown : Verdict::effect;
    }
    for (std::size_t i = 0; i < found.size(); ++i)
      result.findings.push_back(findingOf(i, found, choices[i], fine, meter, result));
    std::stable_sort(result.findings.begin(), result.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.closedLast > b.closedLast; });
    fine.setBase(found);
  }

  /// Of searches in all runs.
  SearchMemory* wholeMemory() const { return onHeldRuns ? nullptr : options.memory; }

  Evaluator &fine, &coarse;
  const DiagnosisOptions& options;
  Proposals proposals;
  bool onHeldRuns = false;
  bool lostCommandsLast = false;  ///< they are not looked for
  bool heldAcross = false;        ///< found by what it predicts of servo settings left out
  const GapMeter meter;
  Diagnosis result;
  Explanation found;
  std::vector<Candidates> choices;  ///< per cause found: what stood for choice, most probable first
};

}  // namespace

const char* nameOf(Verdict verdict) {
  return verdict == Verdict::none ? "none" : verdict == Verdict::effect ? "effect" : "unknown";
}

Explanation Diagnosis::explanation() const {
  Explanation causes;
  for (const Finding& finding : findings) causes.push_back(finding.cause);
  return causes;
}

Diagnosis diagnose(Evaluator& fine, Evaluator& coarse, const DiagnosisOptions& options) {
  return Procedure(fine, coarse, options).run();
}

}  // namespace plumbline::gap
