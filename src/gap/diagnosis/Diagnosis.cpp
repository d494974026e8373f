#include "gap/diagnosis/Diagnosis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "gap/diagnosis/AcrossSettings.h"
#include "gap/diagnosis/FindingOf.h"
#include "gap/diagnosis/GapMeter.h"
#include "gap/diagnosis/Growth.h"
#include "gap/diagnosis/Harm.h"
#include "gap/diagnosis/Merit.h"
#include "gap/diagnosis/Pairs.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/Probability.h"
#include "gap/diagnosis/Remainder.h"
#include "gap/diagnosis/RunsWithout.h"
#include "gap/diagnosis/Search.h"
#include "gap/diagnosis/SharedCauses.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

namespace {

// Of runs on the feet, gap beyond noise over what may remain, at most, where held ones are explained: a joint
// that sticks lets go a moment too late there and leads the rest astray.
constexpr double heldExplained = 0.9;
constexpr double crowded = 0.25;     // more of what remains counts for each further cause at one joint
constexpr double heldOffset = 0.15;  // mean of a sensor at rest over its noise, that no cause may leave
constexpr double farOff = 3;         // times what may remain: no set of causes is worth another look

constexpr double otherStart = 0.7;  // of the best first cause's gain: what gains less is no other start
constexpr std::size_t otherStarts = 3;
constexpr int otherwise = 2;         // looks for recordings with other settings, causes added in between
constexpr double surelyLess = 0.95;  // of the error across settings: another set is not worth it

class Procedure {
public:
  Procedure(Evaluator& fine_, Evaluator& coarse_, const DiagnosisOptions& options_)
      : fine(fine_),
        coarse(coarse_),
        options(options_),
        growth(fine_, coarse_, options_),
        meter((fine_.setBase({}), fine_)) {}

  Diagnosis run() {
    const WorstGap worst = worstGap(fine);
    result.worstBefore = growth.worstBefore = worst.size;
    result.worstSignal = worst.signal;
    result.gap.before = meter.under(fine);
    double remainsHeld = 0;
    if (fine.hasHeld() && fine.hasStanding() && heldRunsTell(fine)) remainsHeld = explainHeldRuns();
    const bool heldTold = !growth.causes.empty();
    if (remainsHeld > 1) {
      // Not known to the library. What came nearest on held runs may topple the robot.
      if (meter.under(fine) > result.gap.before) growth.clear();
    } else if (growth.causes.empty()) {
      explain();
    } else {
      growth.grow();
    }
    acrossSettings();
    if (result.worstBefore >= Growth::present) setOtherwise();
    leaveOutHarm(growth, fine, meter, result.gap.before, options.jobs);
    growth.lookForRivals();
    nameTheMostProbable();
    const WorstGap left = worstGap(fine);
    result.worstAfter = left.size;
    result.worstSignalAfter = left.signal;
    result.gap.after = meter.under(fine);
    judge(remainsHeld, heldTold);
    return result;
  }

private:
  using Candidates = std::vector<Candidate>;

  /// From nothing to the set of causes that predicts best.
  void explain() {
    const double nominal = fine.baseFit().judging;
    growth.grow();
    // With nothing but runs on the feet each look takes a minute, and a second round ten.
    if (!fine.hasHeld()) return;
    beginOtherwise(nominal);
    if (growth.causes.size() > 1 && growth.remainder().mayRemain(farOff)) reconsider();
    otherPair();
  }

  /// What overlaps comes out in pairs and triples that are not there. Where three causes stand for what two
  /// explain, or another two on a robot's only joint predict better, takes these.
  void otherPair() {
    const bool one = hasOneMotor(fine.mechanism());
    const bool explained = !growth.causes.empty() && growth.remainder().mayRemain();
    if (growth.worstBefore < Growth::present || fine.hasStanding()) return;
    if (explained && (growth.causes.size() < 2 || losesCommands(growth.causes))) return;
    if (!one && (growth.causes.size() < 3 || !onOneChain(fine, growth.causes))) return;
    const Explanation old = growth.causes;
    const double leftByOld = fine.baseFit().judging;
    for (Evaluator* evaluator : {&fine, &coarse}) evaluator->setBase({});
    const Explanation pair = bestPair(fine, coarse, options.jobs, [&](double share) {
      if (options.progress) options.progress("pairs of causes", share);
    });
    fine.setBase(pair);
    const bool less = old.size() > 2 && !pair.empty() && growth.remainder().size() < unexplained;
    if (less || (one && !pair.empty() && fine.baseFit().judging < leftByOld - leastGain)) {
      growth.causes = pair;
      growth.choices.assign(pair.size(), {});
      growth.grow();
    } else {
      fine.setBase(old);
    }
  }

  /// Where held runs show what is wrong, they tell it for a hundredth of the price; what remains of them over
  /// what may remain. On the feet only what is found is then looked at, and what those runs show besides.
  double explainHeldRuns() {
    double remains = onHeldRuns([&] { explain(); });
    if (leaveOutHarm(growth, fine, meter, result.gap.before, options.jobs))
      remains = onHeldRuns([&] {
        fine.setBase(growth.causes);
        growth.causes = fitTogether(fine, growth.causes, options.jobs);
      });
    return remains;
  }

  /// Changes the causes as if there were held runs alone; what remains of those over what may remain.
  double onHeldRuns(const std::function<void()>& change) {
    leaveStandingOut(true);
    const double whole = std::exchange(growth.worstBefore, worstGap(fine).size);
    growth.onHeldRuns = true;
    change();
    fine.setBase(growth.causes);
    const double remains = worstGap(fine).size < unexplained ? 0 : growth.remainder().unaccounted();
    growth.onHeldRuns = false;
    growth.worstBefore = whole;
    leaveStandingOut(false);
    fine.setBase(growth.causes);
    return remains;
  }

  void leaveStandingOut(bool out) {
    for (Evaluator* evaluator : {&fine, &coarse}) evaluator->leaveStandingOut(out);
  }

  /// Where much stays unexplained, the first cause may have been the wrong one: begins with others, keeps the
  /// set that predicts best.
  void beginOtherwise(double nominal) {
    if (growth.choices.empty() || growth.remainder().mayRemain() || beginShared()) return;
    // Looking again on the feet takes minutes.
    if (fine.hasStanding() && !growth.causes.empty() && growth.remainder().unaccounted() <= 1) return;
    const Candidates firsts = growth.choices.front();
    if (growth.causes.empty()) growth.choices.clear();
    Explanation best = growth.causes;
    std::vector<Candidates> bestChoices = growth.choices;
    double bestJudging = fine.baseFit().judging;
    for (std::size_t i = 1; i < std::min(firsts.size(), 1 + otherStarts); ++i) {
      if (nominal - firsts[i].fit.judging < otherStart * (nominal - firsts.front().fit.judging)) break;
      growth.causes = {firsts[i].cause};
      growth.choices.assign(1, {});  // what stood for choice before was judged without what comes in now
      fine.setBase(growth.causes);
      growth.grow(bestJudging);
      if (fine.baseFit().judging < bestJudging - leastGain && growth.causes.size() > 1) {
        best = growth.causes;
        bestChoices = growth.choices;
        bestJudging = fine.baseFit().judging;
      }
    }
    growth.causes = std::move(best);
    growth.choices = std::move(bestChoices);
    fine.setBase(growth.causes);
  }

  /// Where all servos are of one type: begins with what they share, chosen together. Whether that took the
  /// place of what was found.
  bool beginShared() {
    if (!fine.mechanism().sharesServo() || fine.hasStanding()) return false;
    const Explanation old = growth.causes;
    fine.setBase({});
    const Explanation set = sharedCauses(fine, options.maxCauses, options.jobs, [&](double share) {
      if (options.progress) options.progress("what servos share", share);
    });
    if (set.empty()) {
      fine.setBase(old);
      return false;
    }
    std::vector<Candidates> kept = std::exchange(growth.choices, std::vector<Candidates>(set.size()));
    growth.causes = set;
    fine.setBase(growth.causes);
    // Lost commands are told cycle by cycle, which takes in much of whatever else is missing.
    growth.lostCommandsLast = true;
    growth.grow();
    if (options.progress) options.progress("each motion from the others", 0);
    const Explanation chosen = betterAcrossMotions(fine, growth.causes, old, options.jobs);
    const bool better = chosen != old;
    growth.causes = chosen;
    fine.setBase(growth.causes);
    if (better) {
      growth.grow();
    } else {
      growth.choices = std::move(kept);
    }
    growth.lostCommandsLast = better;
    if (better) growth.addLostIfNothingRemains();
    return better;
  }

  /// Each cause once more with the others in place: another may do better now, or it may not be needed.
  void reconsider() {
    for (std::size_t i = 0; i < growth.causes.size();) {
      fine.setBase(growth.causes);
      const double whole = fine.baseFit().judging;
      fine.setBase(without(growth.causes, i));
      if (fine.baseFit().judging - whole < leastGain) {
        growth.causes = fine.base();
        growth.choices.erase(growth.choices.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      growth.choices[i] = growth.candidates("each cause again");
      if (!growth.choices[i].empty() && growth.choices[i].front().fit.judging < whole - leastGain)
        growth.causes[i] = growth.choices[i].front().cause;
      ++i;
    }
    fine.setBase(growth.causes);
    growth.causes = fitTogether(fine, growth.causes, options.jobs);
  }

  /// Where runs were recorded under several servo settings and something remains: the set of causes that
  /// predicts each setting from the others best, if it does better than what was found.
  void acrossSettings() {
    if (growth.causes.empty() || fine.hasStanding() || growth.remainder().size() < unexplained) return;
    const AcrossSettings settings(fine.mechanism(), fine.evidence(), options.jobs);
    if (!settings.possible()) return;
    const AcrossSettings quick(fine.mechanism(), fine.evidence(), options.jobs, coarseSteps());
    fine.setBase({});
    const std::vector<Cause> starts = possibleCauses(fine);
    const Explanation set = quick
                                .best(starts, options.maxCauses,
                                      [&](double share) {
                                        if (options.progress) options.progress("across settings", share);
                                      })
                                .causes;
    const AcrossSettings::Tried best = settings.of(set);
    if (best.error < surelyLess * settings.of(growth.causes).error) {
      growth.causes = best.causes;
      growth.choices.assign(growth.causes.size(), {});
      heldAcross = true;
    }
  }

  /// Where something remains: what can be set in a servo need not have been in every recording.
  void setOtherwise() {
    fine.setBase(growth.causes);
    if (fine.hasStanding() || growth.remainder().mayRemain() || beginWithWhatSomeHave()) return;
    for (int pass = 0; pass < otherwise && !growth.causes.empty() && !growth.remainder().mayRemain();
         ++pass) {
      if (options.progress) options.progress("recordings with other settings", 0);
      Explanation set = withoutWhereNotSet(fine, options.jobs);
      if (set == growth.causes) return;
      growth.causes = std::move(set);
      heldAcross = false;
      growth.choices.assign(growth.causes.size(), {});
      fine.setBase(growth.causes);
      growth.grow();
    }
  }

  /// A setting that some recordings had makes whatever fits both kinds best look better than it. Whether
  /// beginning with it explains all.
  bool beginWithWhatSomeHave() {
    const Explanation old = growth.causes;
    std::vector<Candidates> kept = growth.choices;
    fine.setBase({});
    growth.causes = setInSomeRecordings(fine, options.jobs);
    fine.setBase(growth.causes);
    if (!growth.causes.empty() && growth.remainder().mayRemain(farOff)) {
      growth.choices.assign(1, {});
      growth.grow();
      if (growth.remainder().mayRemain()) {
        heldAcross = false;
        return true;
      }
    }
    growth.causes = old;
    growth.choices = std::move(kept);
    fine.setBase(growth.causes);
    return false;
  }

  /// What is left beyond noise may be what a cause predicts better than its rival: of causes that differ by
  /// no more than that, the one named is the more probable one before the data. Sets of several were chosen
  /// by what they predict together.
  void nameTheMostProbable() {
    fine.setBase(growth.causes);
    result.left = leftPerDirection(fine);
    if (growth.causes.size() != 1 || heldAcross || fine.hasStanding()) return;
    Candidates& list = growth.choices.front();
    sortByProbability(list, result.left);
    // Where an effect is may have been chosen otherwise (what is set in one servo is set in all).
    if (list.empty() || list.front().cause.effect == growth.causes.front().effect) return;
    growth.causes.front() = list.front().cause;
    fine.setBase(growth.causes);
  }

  void judge(double remainsHeld, bool heldTold) {
    // What another engine does otherwise may be left of a large gap.
    const Remainder left = growth.remainder();
    double onFeet = left.unaccountedOnFeet();
    if (heldTold && remainsHeld <= 1) onFeet = std::min(onFeet, heldExplained);
    // What predicts a setting that it was not fitted to is not put together for the others.
    const int together = heldAcross ? 1 : mostAtOneJoint(growth.causes);
    double remains = std::max({left.unaccountedHeld(), onFeet, remainsHeld}) * (1 + crowded * (together - 1));
    const WorstGap sensor = worstHeldOffset(fine);
    if (sensor.size > heldOffset) {
      result.sensorOff = sensor.signal;
      result.sensorOffBy = sensor.size;
    }
    remains = std::max(remains, sensor.size / heldOffset);
    result.knownProbability = 1 / (1 + std::exp(6 * (remains - 1)));
    if (growth.causes.empty()) {
      result.verdict = result.worstBefore < unexplained ? Verdict::none : Verdict::unknown;
    } else {
      result.verdict = remains > 1 ? Verdict::unknown : Verdict::effect;
    }
    for (std::size_t i = 0; i < growth.causes.size(); ++i)
      result.findings.push_back(findingOf(i, growth.causes, growth.choices[i], fine, meter, result));
    std::stable_sort(result.findings.begin(), result.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.closedLast > b.closedLast; });
    fine.setBase(growth.causes);
  }

  Evaluator &fine, &coarse;
  const DiagnosisOptions& options;
  Growth growth;
  bool heldAcross = false;  ///< found by what it predicts of servo settings left out
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
