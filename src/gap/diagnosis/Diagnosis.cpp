#include "gap/diagnosis/Diagnosis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/ConfigurationChange.h"
#include "gap/diagnosis/FindingOf.h"
#include "gap/diagnosis/ForwardSelection.h"
#include "gap/diagnosis/GapMeter.h"
#include "gap/diagnosis/GroupedCrossValidation.h"
#include "gap/diagnosis/Merit.h"
#include "gap/diagnosis/Pairs.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/Probability.h"
#include "gap/diagnosis/PruneHarmful.h"
#include "gap/diagnosis/Remainder.h"
#include "gap/diagnosis/SharedCauses.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

namespace {

// Gap beyond noise over what may remain, of runs on a floating base, at most, where those on a fixed base are
// explained: a joint that sticks lets go a moment too late on the feet, and the rest of the run differs.
constexpr double maxFloatingBaseLeft = 0.9;
constexpr double crowded = 0.25;        // more of what remains counts for each further cause at one joint
constexpr double maxRestOffset = 0.15;  // mean of a sensor at rest over its noise, that no cause may leave
constexpr double farOff = 3;            // times what may remain: no set of causes is worth another look

constexpr double otherStart = 0.7;  // of the best first cause's gain: what gains less is no other start
constexpr std::size_t otherStarts = 3;
constexpr int configurationPasses = 2;  // looks for recordings with other settings, causes added in between
constexpr double maxErrorShare = 0.95;  // of the error across settings: another set is not worth it

class Procedure {
public:
  Procedure(Evaluator& fine_, Evaluator& coarse_, const DiagnosisOptions& options_)
      : fine(fine_),
        coarse(coarse_),
        options(options_),
        selection(fine_, coarse_, options_),
        meter((fine_.setBase({}), fine_)) {}

  Diagnosis run() {
    const WorstGap worst = worstGap(fine);
    result.worstBefore = selection.worstBefore = worst.size;
    result.worstSignal = worst.signal;
    result.gap.before = meter.under(fine);
    double leftOnFixedBase = 0;
    if (fine.hasFixedBase() && fine.hasFloatingBase() && fixedBaseDecides(fine))
      leftOnFixedBase = explainFixedBaseRuns();
    const bool foundOnFixedBase = !selection.causes.empty();
    if (leftOnFixedBase > 1) {
      // Not known to the library. What came nearest on held runs may topple the robot.
      if (meter.under(fine) > result.gap.before) selection.clear();
    } else if (selection.causes.empty()) {
      explain();
    } else {
      selection.grow();
    }
    crossValidate();
    if (result.worstBefore >= ForwardSelection::present) lookForConfigurationChanges();
    pruneHarmful(selection, fine, meter, result.gap.before, options.jobs);
    selection.lookForRivals();
    nameTheMostProbable();
    const WorstGap left = worstGap(fine);
    result.worstAfter = left.size;
    result.worstSignalAfter = left.signal;
    result.gap.after = meter.under(fine);
    judge(leftOnFixedBase, foundOnFixedBase);
    return result;
  }

private:
  using Candidates = std::vector<Candidate>;

  /// From nothing to the set of causes that predicts best.
  void explain() {
    const double nominal = fine.baseFit().judging;
    selection.grow();
    // With nothing but runs on the feet each look takes a minute, and a second round ten.
    if (!fine.hasFixedBase()) return;
    tryOtherFirstCauses(nominal);
    if (selection.causes.size() > 1 && selection.remainder().mayRemain(farOff)) reconsider();
    otherPair();
  }

  /// What overlaps comes out in pairs and triples that are not there. Where three causes stand for what two
  /// explain, or another two on a robot's only joint predict better, takes these.
  void otherPair() {
    const bool one = hasOneMotor(fine.mechanism());
    const bool explained = !selection.causes.empty() && selection.remainder().mayRemain();
    if (selection.worstBefore < ForwardSelection::present || fine.hasFloatingBase()) return;
    if (explained && (selection.causes.size() < 2 || losesCommands(selection.causes))) return;
    if (!one && (selection.causes.size() < 3 || !onOneChain(fine, selection.causes))) return;
    const Explanation old = selection.causes;
    const double leftByOld = fine.baseFit().judging;
    for (Evaluator* evaluator : {&fine, &coarse}) evaluator->setBase({});
    const Explanation pair = bestPair(fine, coarse, options.jobs, [&](double share) {
      if (options.progress) options.progress("pairs of causes", share);
    });
    fine.setBase(pair);
    const bool less = old.size() > 2 && !pair.empty() && selection.remainder().size() < unexplained;
    if (less || (one && !pair.empty() && fine.baseFit().judging < leftByOld - leastGain)) {
      selection.causes = pair;
      selection.choices.assign(pair.size(), {});
      selection.grow();
    } else {
      fine.setBase(old);
    }
  }

  /// Where held runs show what is wrong, they tell it for a hundredth of the price; what remains of them over
  /// what may remain. On the feet only what is found is then looked at, and what those runs show besides.
  double explainFixedBaseRuns() {
    double remains = onFixedBaseRuns([&] { explain(); });
    if (pruneHarmful(selection, fine, meter, result.gap.before, options.jobs))
      remains = onFixedBaseRuns([&] {
        fine.setBase(selection.causes);
        selection.causes = fitTogether(fine, selection.causes, options.jobs);
      });
    return remains;
  }

  /// Changes the causes as if there were held runs alone; what remains of those over what may remain.
  double onFixedBaseRuns(const std::function<void()>& change) {
    leaveFloatingBaseOut(true);
    const double whole = std::exchange(selection.worstBefore, worstGap(fine).size);
    selection.onFixedBaseRuns = true;
    change();
    fine.setBase(selection.causes);
    const double remains = worstGap(fine).size < unexplained ? 0 : selection.remainder().unaccounted();
    selection.onFixedBaseRuns = false;
    selection.worstBefore = whole;
    leaveFloatingBaseOut(false);
    fine.setBase(selection.causes);
    return remains;
  }

  void leaveFloatingBaseOut(bool out) {
    for (Evaluator* evaluator : {&fine, &coarse}) evaluator->leaveFloatingBaseOut(out);
  }

  /// Where much stays unexplained, the first cause may have been the wrong one: begins with others, keeps the
  /// set that predicts best.
  void tryOtherFirstCauses(double nominal) {
    if (selection.choices.empty() || selection.remainder().mayRemain() || beginShared()) return;
    // Looking again on the feet takes minutes.
    if (fine.hasFloatingBase() && !selection.causes.empty() && selection.remainder().unaccounted() <= 1)
      return;
    const Candidates firsts = selection.choices.front();
    if (selection.causes.empty()) selection.choices.clear();
    Explanation best = selection.causes;
    std::vector<Candidates> bestChoices = selection.choices;
    double bestJudging = fine.baseFit().judging;
    for (std::size_t i = 1; i < std::min(firsts.size(), 1 + otherStarts); ++i) {
      if (nominal - firsts[i].fit.judging < otherStart * (nominal - firsts.front().fit.judging)) break;
      selection.causes = {firsts[i].cause};
      selection.choices.assign(1, {});  // what stood for choice before was judged without what comes in now
      fine.setBase(selection.causes);
      selection.grow(bestJudging);
      if (fine.baseFit().judging < bestJudging - leastGain && selection.causes.size() > 1) {
        best = selection.causes;
        bestChoices = selection.choices;
        bestJudging = fine.baseFit().judging;
      }
    }
    selection.causes = std::move(best);
    selection.choices = std::move(bestChoices);
    fine.setBase(selection.causes);
  }

  /// Where all servos are of one type: begins with what they share, chosen together. Whether that took the
  /// place of what was found.
  bool beginShared() {
    if (!fine.mechanism().sharesServo() || fine.hasFloatingBase()) return false;
    const Explanation old = selection.causes;
    fine.setBase({});
    const Explanation set = sharedCauses(fine, options.maxCauses, options.jobs, [&](double share) {
      if (options.progress) options.progress("what servos share", share);
    });
    if (set.empty()) {
      fine.setBase(old);
      return false;
    }
    std::vector<Candidates> kept = std::exchange(selection.choices, std::vector<Candidates>(set.size()));
    selection.causes = set;
    fine.setBase(selection.causes);
    // Lost commands are told cycle by cycle, which takes in much of whatever else is missing.
    selection.lostCommandsLast = true;
    selection.grow();
    if (options.progress) options.progress("each motion from the others", 0);
    const Explanation chosen = betterAcrossMotions(fine, selection.causes, old, options.jobs);
    const bool better = chosen != old;
    selection.causes = chosen;
    fine.setBase(selection.causes);
    if (better) {
      selection.grow();
    } else {
      selection.choices = std::move(kept);
    }
    selection.lostCommandsLast = better;
    if (better) selection.addLostIfNothingRemains();
    return better;
  }

  /// Each cause once more with the others in place: another may do better now, or it may not be needed.
  void reconsider() {
    for (std::size_t i = 0; i < selection.causes.size();) {
      fine.setBase(selection.causes);
      const double whole = fine.baseFit().judging;
      fine.setBase(without(selection.causes, i));
      if (fine.baseFit().judging - whole < leastGain) {
        selection.causes = fine.base();
        selection.choices.erase(selection.choices.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      selection.choices[i] = selection.candidates("each cause again");
      if (!selection.choices[i].empty() && selection.choices[i].front().fit.judging < whole - leastGain)
        selection.causes[i] = selection.choices[i].front().cause;
      ++i;
    }
    fine.setBase(selection.causes);
    selection.causes = fitTogether(fine, selection.causes, options.jobs);
  }

  /// Where runs were recorded under several servo settings and something remains: the set of causes that
  /// predicts each setting from the others best, if it does better than what was found.
  void crossValidate() {
    if (selection.causes.empty() || fine.hasFloatingBase() || selection.remainder().size() < unexplained)
      return;
    const GroupedCrossValidation settings(fine.mechanism(), fine.evidence(), options.jobs);
    if (!settings.possible()) return;
    const GroupedCrossValidation quick(fine.mechanism(), fine.evidence(), options.jobs, coarseSteps());
    fine.setBase({});
    const std::vector<Cause> starts = possibleCauses(fine);
    const Explanation set = quick
                                .best(starts, options.maxCauses,
                                      [&](double share) {
                                        if (options.progress) options.progress("across settings", share);
                                      })
                                .causes;
    const GroupedCrossValidation::Tried best = settings.of(set);
    if (best.error < maxErrorShare * settings.of(selection.causes).error) {
      selection.causes = best.causes;
      selection.choices.assign(selection.causes.size(), {});
      chosenAcrossGroups = true;
    }
  }

  /// Where something remains: what can be set in a servo need not have been in every recording.
  void lookForConfigurationChanges() {
    fine.setBase(selection.causes);
    if (fine.hasFloatingBase() || selection.remainder().mayRemain() || tryConfigurationOfSome()) return;
    for (int pass = 0;
         pass < configurationPasses && !selection.causes.empty() && !selection.remainder().mayRemain();
         ++pass) {
      if (options.progress) options.progress("recordings with other settings", 0);
      Explanation set = inactiveWhereNotSet(fine, options.jobs);
      if (set == selection.causes) return;
      selection.causes = std::move(set);
      chosenAcrossGroups = false;
      selection.choices.assign(selection.causes.size(), {});
      fine.setBase(selection.causes);
      selection.grow();
    }
  }

  /// A setting that some recordings had makes whatever fits both kinds best look better than it. Whether
  /// beginning with it explains all.
  bool tryConfigurationOfSome() {
    const Explanation old = selection.causes;
    std::vector<Candidates> kept = selection.choices;
    fine.setBase({});
    selection.causes = configurationOfSome(fine, options.jobs);
    fine.setBase(selection.causes);
    if (!selection.causes.empty() && selection.remainder().mayRemain(farOff)) {
      selection.choices.assign(1, {});
      selection.grow();
      if (selection.remainder().mayRemain()) {
        chosenAcrossGroups = false;
        return true;
      }
    }
    selection.causes = old;
    selection.choices = std::move(kept);
    fine.setBase(selection.causes);
    return false;
  }

  /// What is left beyond noise may be what a cause predicts better than its rival: of causes that differ by
  /// no more than that, the one named is the more probable one before the data. Sets of several were chosen
  /// by what they predict together.
  void nameTheMostProbable() {
    fine.setBase(selection.causes);
    result.left = leftPerDirection(fine);
    if (selection.causes.size() != 1 || chosenAcrossGroups || fine.hasFloatingBase()) return;
    Candidates& list = selection.choices.front();
    sortByProbability(list, result.left);
    // Where an effect is may have been chosen otherwise (what is set in one servo is set in all).
    if (list.empty() || list.front().cause.effect == selection.causes.front().effect) return;
    selection.causes.front() = list.front().cause;
    fine.setBase(selection.causes);
  }

  void judge(double leftOnFixedBase, bool foundOnFixedBase) {
    // What another engine does otherwise may be left of a large gap.
    const Remainder left = selection.remainder();
    double onFeet = left.unaccountedOnFloatingBase();
    if (foundOnFixedBase && leftOnFixedBase <= 1) onFeet = std::min(onFeet, maxFloatingBaseLeft);
    // What predicts a setting that it was not fitted to is not put together for the others.
    const int together = chosenAcrossGroups ? 1 : mostAtOneJoint(selection.causes);
    double remains =
        std::max({left.unaccountedOnFixedBase(), onFeet, leftOnFixedBase}) * (1 + crowded * (together - 1));
    const WorstGap sensor = worstRestOffset(fine);
    if (sensor.size > maxRestOffset) {
      result.sensorOff = sensor.signal;
      result.sensorOffBy = sensor.size;
    }
    remains = std::max(remains, sensor.size / maxRestOffset);
    result.knownProbability = 1 / (1 + std::exp(6 * (remains - 1)));
    if (selection.causes.empty()) {
      result.verdict = result.worstBefore < unexplained ? Verdict::none : Verdict::unknown;
    } else {
      result.verdict = remains > 1 ? Verdict::unknown : Verdict::effect;
    }
    for (std::size_t i = 0; i < selection.causes.size(); ++i)
      result.findings.push_back(findingOf(i, selection.causes, selection.choices[i], fine, meter, result));
    std::stable_sort(result.findings.begin(), result.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.closedLast > b.closedLast; });
    fine.setBase(selection.causes);
  }

  Evaluator &fine, &coarse;
  const DiagnosisOptions& options;
  ForwardSelection selection;
  bool chosenAcrossGroups = false;  ///< found by what it predicts of servo settings left out
  const GapMeter meter;
  Diagnosis result;
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
