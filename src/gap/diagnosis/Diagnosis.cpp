#include "gap/diagnosis/Diagnosis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "gap/diagnosis/AcceptanceTest.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/ConfigurationChange.h"
#include "gap/diagnosis/FindingOf.h"
#include "gap/diagnosis/ForwardSelection.h"
#include "gap/diagnosis/GapMeter.h"
#include "gap/diagnosis/GroupedCrossValidation.h"
#include "gap/diagnosis/Pairs.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/Probability.h"
#include "gap/diagnosis/PruneHarmful.h"
#include "gap/diagnosis/Remainder.h"
#include "gap/diagnosis/SharedCauses.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

namespace {

// Largest gap beyond noise, relative to the allowed remainder, of runs on a floating base if those on a fixed
// base are explained. On the feet a sticking joint lets go a moment too late, and then the rest of the run
// differs.
constexpr double maxFloatingBaseLeft = 0.9;
constexpr double shareOfFurther = 0.25;  // more of what remains counts for each further cause at one joint
constexpr double maxRestOffset = 0.15;   // mean of a sensor at rest over its noise, that no cause may leave
constexpr double mostRemainder = 3;      // times what may remain: no set of causes is worth another look

constexpr double leastGainShare = 0.7;  // of the best first cause's gain: what gains less is no other start
constexpr std::size_t otherStarts = 3;
constexpr int configurationPasses = 2;  // looks for recordings with other settings, causes added in between
constexpr double maxErrorShare = 0.95;  // of the error across settings: another set is not worth it

class Procedure {
public:
  Procedure(Evaluator& fine, Evaluator& coarse, const DiagnosisOptions& options)
      : fine_(fine),
        coarse_(coarse),
        options_(options),
        selection_(fine, coarse, options),
        meter_((fine.setBase({}), fine)) {}

  Diagnosis run() {
    const WorstGap worst = worstGap(fine_);
    result_.worstBefore = selection_.worstBefore = worst.size;
    result_.worstSignal = worst.signal;
    result_.gap.before = meter_.under(fine_);
    double leftOnFixedBase = 0;
    if (fine_.hasFixedBase() && fine_.hasFloatingBase() && fixedBaseDecides(fine_))
      leftOnFixedBase = explainFixedBaseRuns();
    const bool foundOnFixedBase = !selection_.causes.empty();
    if (leftOnFixedBase > 1) {
      // The cause is not in the library. The best one on a fixed base may topple the robot.
      if (meter_.under(fine_) > result_.gap.before) selection_.clear();
    } else if (selection_.causes.empty()) {
      explain();
    } else {
      selection_.grow();
    }
    crossValidate();
    if (result_.worstBefore >= ForwardSelection::present) lookForConfigurationChanges();
    pruneHarmful(selection_, fine_, meter_, result_.gap.before, options_.jobs);
    selection_.lookForRivals();
    nameTheMostProbable();
    const WorstGap left = worstGap(fine_);
    result_.worstAfter = left.size;
    result_.worstSignalAfter = left.signal;
    result_.gap.after = meter_.under(fine_);
    judge(leftOnFixedBase, foundOnFixedBase);
    return result_;
  }

private:
  using Candidates = std::vector<FittedCause>;

  /// From nothing to the set of causes that predicts best.
  void explain() {
    const double nominal = fine_.baseFit().judging;
    selection_.grow();
    // With runs on the feet only, each search takes a minute, and a second round takes ten.
    if (!fine_.hasFixedBase()) return;
    tryOtherFirstCauses(nominal);
    if (selection_.causes.size() > 1 && selection_.remainder().mayRemain(mostRemainder)) reconsider();
    otherPair();
  }

  /// Overlapping effects are found as wrong pairs or triples. If two causes explain as much as three, or
  /// another pair on a robot's only joint predicts better, the two are taken.
  void otherPair() {
    const bool one = hasOneMotor(fine_.mechanism());
    const bool explained = !selection_.causes.empty() && selection_.remainder().mayRemain();
    if (selection_.worstBefore < ForwardSelection::present || fine_.hasFloatingBase()) return;
    if (explained && (selection_.causes.size() < 2 || losesCommands(selection_.causes))) return;
    if (!one && (selection_.causes.size() < 3 || !onOneChain(fine_, selection_.causes))) return;
    const Explanation old = selection_.causes;
    const double leftByOld = fine_.baseFit().judging;
    for (Evaluator* evaluator : {&fine_, &coarse_}) evaluator->setBase({});
    const Explanation pair = bestPair(fine_, coarse_, options_.jobs, [&](double share) {
      if (options_.progress) options_.progress("pairs of causes", share);
    });
    fine_.setBase(pair);
    const bool less = old.size() > 2 && !pair.empty() && selection_.remainder().size() < unexplained;
    if (less || (one && !pair.empty() && fine_.baseFit().judging < leftByOld - leastGain)) {
      selection_.causes = pair;
      selection_.choices.assign(pair.size(), {});
      selection_.grow();
    } else {
      fine_.setBase(old);
    }
  }

  /// Searches the runs with a fixed base first, which cost a hundredth of the others. On the feet it then
  /// tests what was found, and searches what else those runs show. Returns the remainder on a fixed base over
  /// the allowed one.
  double explainFixedBaseRuns() {
    double remains = onFixedBaseRuns([&] { explain(); });
    if (pruneHarmful(selection_, fine_, meter_, result_.gap.before, options_.jobs))
      remains = onFixedBaseRuns([&] {
        fine_.setBase(selection_.causes);
        selection_.causes = fitTogether(fine_, selection_.causes, options_.jobs);
      });
    return remains;
  }

  /// Changes the causes as if there were only runs with a fixed base; returns their remainder over the
  /// allowed one.
  double onFixedBaseRuns(const std::function<void()>& change) {
    leaveFloatingBaseOut(true);
    const double whole = std::exchange(selection_.worstBefore, worstGap(fine_).size);
    selection_.onFixedBaseRuns = true;
    change();
    fine_.setBase(selection_.causes);
    const double remains = worstGap(fine_).size < unexplained ? 0 : selection_.remainder().unaccounted();
    selection_.onFixedBaseRuns = false;
    selection_.worstBefore = whole;
    leaveFloatingBaseOut(false);
    fine_.setBase(selection_.causes);
    return remains;
  }

  void leaveFloatingBaseOut(bool out) {
    for (Evaluator* evaluator : {&fine_, &coarse_}) evaluator->leaveFloatingBaseOut(out);
  }

  /// If much stays unexplained, the first cause may have been wrong: starts with others and keeps the set
  /// that predicts best.
  void tryOtherFirstCauses(double nominal) {
    if (selection_.choices.empty() || selection_.remainder().mayRemain() || beginShared()) return;
    // A second search on the feet takes minutes.
    if (fine_.hasFloatingBase() && !selection_.causes.empty() && selection_.remainder().unaccounted() <= 1)
      return;
    const Candidates firsts = selection_.choices.front();
    if (selection_.causes.empty()) selection_.choices.clear();
    Explanation best = selection_.causes;
    std::vector<Candidates> bestChoices = selection_.choices;
    double bestJudging = fine_.baseFit().judging;
    for (std::size_t i = 1; i < std::min(firsts.size(), 1 + otherStarts); ++i) {
      if (nominal - firsts[i].fit.judging < leastGainShare * (nominal - firsts.front().fit.judging)) break;
      selection_.causes = {firsts[i].cause};
      selection_.choices.assign(1, {});  // what stood for choice before was judged without what comes in now
      fine_.setBase(selection_.causes);
      selection_.grow(bestJudging);
      if (fine_.baseFit().judging < bestJudging - leastGain && selection_.causes.size() > 1) {
        best = selection_.causes;
        bestChoices = selection_.choices;
        bestJudging = fine_.baseFit().judging;
      }
    }
    selection_.causes = std::move(best);
    selection_.choices = std::move(bestChoices);
    fine_.setBase(selection_.causes);
  }

  /// If all servos are of one type: starts with the causes they share, chosen together. Returns whether these
  /// replaced the causes found.
  bool beginShared() {
    if (!fine_.mechanism().sharesServo() || fine_.hasFloatingBase()) return false;
    const Explanation old = selection_.causes;
    fine_.setBase({});
    const Explanation set = sharedCauses(fine_, options_.maxCauses, options_.jobs, [&](double share) {
      if (options_.progress) options_.progress("what servos share", share);
    });
    if (set.empty()) {
      fine_.setBase(old);
      return false;
    }
    std::vector<Candidates> kept = std::exchange(selection_.choices, std::vector<Candidates>(set.size()));
    selection_.causes = set;
    fine_.setBase(selection_.causes);
    // Lost commands are fitted cycle by cycle, which absorbs much of what else is missing.
    selection_.lostCommandsLast = true;
    selection_.grow();
    if (options_.progress) options_.progress("each motion from the others", 0);
    const Explanation chosen = betterAcrossMotions(fine_, selection_.causes, old, options_.jobs);
    const bool better = chosen != old;
    selection_.causes = chosen;
    fine_.setBase(selection_.causes);
    if (better) {
      selection_.grow();
    } else {
      selection_.choices = std::move(kept);
    }
    selection_.lostCommandsLast = better;
    if (better) selection_.addLostIfNothingRemains();
    return better;
  }

  /// Tests each cause again with the others: another may now be better, or the cause may not be needed.
  void reconsider() {
    for (std::size_t i = 0; i < selection_.causes.size();) {
      fine_.setBase(selection_.causes);
      const double whole = fine_.baseFit().judging;
      fine_.setBase(without(selection_.causes, i));
      if (fine_.baseFit().judging - whole < leastGain) {
        selection_.causes = fine_.base();
        selection_.choices.erase(selection_.choices.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      selection_.choices[i] = selection_.candidates("each cause again");
      if (!selection_.choices[i].empty() && selection_.choices[i].front().fit.judging < whole - leastGain)
        selection_.causes[i] = selection_.choices[i].front().cause;
      ++i;
    }
    fine_.setBase(selection_.causes);
    selection_.causes = fitTogether(fine_, selection_.causes, options_.jobs);
  }

  /// If runs have several servo settings and something remains: takes the set of causes that best predicts
  /// each setting from the others, if it is better than the causes found.
  void crossValidate() {
    if (selection_.causes.empty() || fine_.hasFloatingBase() || selection_.remainder().size() < unexplained)
      return;
    const GroupedCrossValidation settings(fine_.mechanism(), fine_.evidence(), options_.jobs);
    if (!settings.possible()) return;
    const GroupedCrossValidation quick(fine_.mechanism(), fine_.evidence(), options_.jobs, coarseSteps());
    fine_.setBase({});
    const std::vector<Cause> starts = possibleCauses(fine_);
    const Explanation set = quick
                                .best(starts, options_.maxCauses,
                                      [&](double share) {
                                        if (options_.progress) options_.progress("across settings", share);
                                      })
                                .causes;
    const GroupedCrossValidation::Tried best = settings.of(set);
    if (best.error < maxErrorShare * settings.of(selection_.causes).error) {
      selection_.causes = best.causes;
      selection_.choices.assign(selection_.causes.size(), {});
      chosenAcrossGroups_ = true;
    }
  }

  /// If something remains: a cause that is a servo setting may be inactive in some recordings.
  void lookForConfigurationChanges() {
    fine_.setBase(selection_.causes);
    if (fine_.hasFloatingBase() || selection_.remainder().mayRemain() || tryConfigurationOfSome()) return;
    for (int pass = 0;
         pass < configurationPasses && !selection_.causes.empty() && !selection_.remainder().mayRemain();
         ++pass) {
      if (options_.progress) options_.progress("recordings with other settings", 0);
      Explanation set = inactiveWhereNotSet(fine_, options_.jobs);
      if (set == selection_.causes) return;
      selection_.causes = std::move(set);
      chosenAcrossGroups_ = false;
      selection_.choices.assign(selection_.causes.size(), {});
      fine_.setBase(selection_.causes);
      selection_.grow();
    }
  }

  /// If only some recordings had a setting, a cause that fits both kinds can look better than it. Returns
  /// whether a start with the setting explains all.
  bool tryConfigurationOfSome() {
    const Explanation old = selection_.causes;
    std::vector<Candidates> kept = selection_.choices;
    fine_.setBase({});
    selection_.causes = configurationOfSome(fine_, options_.jobs);
    fine_.setBase(selection_.causes);
    if (!selection_.causes.empty() && selection_.remainder().mayRemain(mostRemainder)) {
      selection_.choices.assign(1, {});
      selection_.grow();
      if (selection_.remainder().mayRemain()) {
        chosenAcrossGroups_ = false;
        return true;
      }
    }
    selection_.causes = old;
    selection_.choices = std::move(kept);
    fine_.setBase(selection_.causes);
    return false;
  }

  /// The remainder beyond noise can make a cause look better than its rival. Of causes that differ by no more
  /// than that, it names the one that is more probable before the data. Sets of several causes were chosen by
  /// what they predict together.
  void nameTheMostProbable() {
    fine_.setBase(selection_.causes);
    result_.left = leftPerDirection(fine_);
    if (selection_.causes.size() != 1 || chosenAcrossGroups_ || fine_.hasFloatingBase()) return;
    Candidates& list = selection_.choices.front();
    sortByProbability(list, result_.left);
    // The place of an effect may have another reason (a setting of one servo is assumed in all).
    if (list.empty() || list.front().cause.effect == selection_.causes.front().effect) return;
    selection_.causes.front() = list.front().cause;
    fine_.setBase(selection_.causes);
  }

  void judge(double leftOnFixedBase, bool foundOnFixedBase) {
    // Of a large gap, the differences of another engine may remain.
    const Remainder left = selection_.remainder();
    double onFeet = left.unaccountedOnFloatingBase();
    if (foundOnFixedBase && leftOnFixedBase <= 1) onFeet = std::min(onFeet, maxFloatingBaseLeft);
    // A set that predicts a setting without being fitted to it is no chance combination.
    const int together = chosenAcrossGroups_ ? 1 : mostAtOneJoint(selection_.causes);
    double remains = std::max({left.unaccountedOnFixedBase(), onFeet, leftOnFixedBase}) *
                     (1 + shareOfFurther * (together - 1));
    const WorstGap sensor = worstRestOffset(fine_);
    if (sensor.size > maxRestOffset) {
      result_.sensorOff = sensor.signal;
      result_.sensorOffBy = sensor.size;
    }
    remains = std::max(remains, sensor.size / maxRestOffset);
    result_.knownProbability = 1 / (1 + std::exp(6 * (remains - 1)));
    if (selection_.causes.empty()) {
      result_.verdict = result_.worstBefore < unexplained ? Verdict::none : Verdict::unknown;
    } else {
      result_.verdict = remains > 1 ? Verdict::unknown : Verdict::effect;
    }
    for (std::size_t i = 0; i < selection_.causes.size(); ++i)
      result_.findings.push_back(
          findingOf(i, selection_.causes, selection_.choices[i], fine_, meter_, result_));
    std::stable_sort(result_.findings.begin(), result_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.closedLast > b.closedLast; });
    fine_.setBase(selection_.causes);
  }

  Evaluator &fine_, &coarse_;
  const DiagnosisOptions& options_;
  ForwardSelection selection_;
  bool chosenAcrossGroups_ = false;  ///< found by what it predicts of servo settings left out
  const GapMeter meter_;
  Diagnosis result_;
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
