#include "gap/diagnosis/ForwardSelection.h"

#include <algorithm>
#include <utility>

#include "gap/diagnosis/AcceptanceTest.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/LostCycles.h"
#include "gap/diagnosis/Probability.h"

namespace plumbline::gap {

namespace {

// Where only a little of the gap is left (Remainder::little), a further cause has to explain
// most of that, and to be more probable than all others together.
constexpr double minShareOfRest = 0.6, minProbability = 0.5;
constexpr double maxGainLost = 0.3;  // of the best candidate's gain lost: not tried as a further cause
constexpr std::size_t mostTried = 3;
constexpr int passes = 6;               // of decoding and fitting in turn
constexpr double strengthRatio = 1.5;   // to what was fitted: losses may imitate the rest
constexpr double maxErrorRatio = 1.05;  // of the squares for judging: up to this, no worse

}  // namespace

void ForwardSelection::grow(double most) {
  while (causes.size() < options_.maxCauses &&
         (causes.empty() ? worstGap(fine_).size >= present : remainder().size() >= unexplained)) {
    if (causes.size() > 1 && fine_.baseFit().judging > most) break;
    std::vector<FittedCause> list = candidates(causes.empty() ? "first cause" : "further cause",
                                               !causes.empty() && remainder().onlyOfSensors());
    if (!accept(list)) {
      if (choices.empty()) choices.push_back(std::move(list));
      break;
    }
    causes = fine_.base();
    settleLosses();
    // A setting of one servo may have been assumed in all servos: its rivals are searched at the end.
    const auto same = [&](const FittedCause& c) { return c.cause.sameKind(causes.back()); };
    if (std::ranges::none_of(list, same)) list.clear();
    choices.push_back(std::move(list));
  }
}

/// Adds each of the best candidates to the base, fits values that depend on each other together, and keeps
/// the most probable candidate that passes the test.
bool ForwardSelection::accept(const std::vector<FittedCause>& list) {
  if (list.empty()) return false;
  const AcceptanceTest before(fine_);
  const double part = leastPart();
  // Where little is left, a cause that is less probable than all others together is a guess.
  if (part > 0 && probabilities(list).front() < minProbability) return false;
  const Explanation old = fine_.base();
  const double front = list.front().fit.judging, least = front + maxGainLost * (before.judging() - front);
  Explanation best;
  double bestJudging = INFINITY, bestPriced = INFINITY;
  for (std::size_t i = 0; i < std::min(old.empty() ? 1 : mostTried, list.size()); ++i) {
    if (list[i].fit.judging > least) break;
    setBaseTo(old, list[i].cause);
    const double judging = fine_.baseFit().judging, priced = withPrior(list[i].cause, judging);
    if (priced < bestPriced && before.passes(fine_, part)) {
      best = fine_.base();
      bestJudging = judging;
      bestPriced = priced;
    }
  }
  if (!best.empty() && isOneServosSetting(best.back())) {
    Cause all = best.back();
    all.place = {Site::everywhere, -1, "*"};
    const auto isIt = [&](const Cause& cause) { return cause.sameKind(all); };
    fine_.setBase(best);
    if (std::ranges::none_of(old, isIt)) setBaseTo(old, all);
    if (fine_.baseFit().judging < maxErrorRatio * bestJudging && before.passes(fine_, part))
      best = fine_.base();
  }
  fine_.setBase(best.empty() ? old : best);
  return !best.empty();
}

/// Adds a cause to some; values that depend on each other are fitted together.
void ForwardSelection::setBaseTo(const Explanation& old, const Cause& cause) {
  Explanation tried = old;
  tried.push_back(cause);
  fine_.setBase(old);
  const Explanation together =
      ofSensor(cause) ? tried : fitTogether(proposals_.quickOn(old), tried, options_.jobs);
  const bool better = together == tried || fine_.of(together).fitting < fine_.of(tried).fitting;
  fine_.setBase(better ? together : tried);
}

/// Lost commands were decoded before the other causes were known, and these were fitted with those losses.
/// Repeats both in turn while that predicts better. Losses can imitate a part of the other causes, so these
/// are also tried with a greater strength than fitted.
void ForwardSelection::settleLosses() {
  if (causes.size() < 2 || !losesCommands(causes)) return;
  for (int pass = 0; pass < passes; ++pass)
    if (!decodeLossesWith(1) && !decodeLossesWith(strengthRatio)) return;
}

/// Decodes lost commands with the other causes at `strength` times their strength, then fits these again;
/// keeps the result if it predicts better.
bool ForwardSelection::decodeLossesWith(double strength) {
  const double before = fine_.baseFit().judging;
  const auto cyclesBefore = fine_.lostCycles();
  Explanation others, tried = causes;
  for (Cause& cause : tried) {
    if (cause.effect->decoded) continue;
    cause = scaled(fine_.mechanism(), cause, strength);
    others.push_back(cause);
  }
  const LostCycles again = findLostCycles(fine_.evidence(), others, options_.jobs);
  proposals_.useLostCycles(again.cycles);
  for (Cause& cause : tried)
    if (cause.effect->decoded) cause.value = again.share;
  fine_.setBase(tried);
  fine_.setBase(fitTogether(fine_, tried, options_.jobs));
  const bool better = fine_.baseFit().judging < before - leastGain;
  if (better) {
    causes = fine_.base();
  } else {
    proposals_.useLostCycles(cyclesBefore);
    fine_.setBase(causes);
  }
  return better;
}

/// Whether a cause is set in one servo of a robot whose servos are all of one type. What is set in one is
/// set in all of them, unless the data speak against it.
bool ForwardSelection::isOneServosSetting(const Cause& cause) const {
  const Effect& effect = *cause.effect;
  return effect.setting && effect.ofServo && cause.place.site == Site::joint &&
         fine_.mechanism().sharesServo();
}

/// Share of the unexplained gap that a further cause must explain. If little is left of a large gap, it may
/// be that the effects found act slightly differently in reality. Then only a cause that explains most of it
/// counts.
double ForwardSelection::leastPart() const {
  return !fine_.base().empty() && remainder().little() ? minShareOfRest : 0;
}

void ForwardSelection::addLostIfNothingRemains() {
  std::vector<FittedCause> lost;
  if (causes.size() < options_.maxCauses && !remainder().mayRemain()) proposals_.addLostCommands(lost);
  if (lost.empty()) return;
  causes.push_back(lost.front().cause);
  fine_.setBase(causes);
  if (remainder().mayRemain()) {
    choices.push_back(std::move(lost));
    lostCommandsLast = false;
  } else {
    causes.pop_back();
    fine_.setBase(causes);
  }
}

std::vector<FittedCause> ForwardSelection::candidates(const std::string& stage, bool onlySensors) {
  return proposals_.find({.stage = stage,
                          .leastGain = leastPart() / 2 * std::max(0.0, excess(fine_)),
                          .onlySensors = onlySensors,
                          .lostCommands = !lostCommandsLast,
                          .memory = onFixedBaseRuns ? nullptr : options_.memory});
}

void ForwardSelection::lookForRivals() {
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if (!choices[i].empty()) continue;
    fine_.setBase(without(causes, i));
    choices[i] = withItself(candidates("each cause again"), causes[i]);
  }
  fine_.setBase(causes);
}

/// The alternatives to a cause that was chosen in another way; its value is fitted like theirs.
std::vector<FittedCause> ForwardSelection::withItself(std::vector<FittedCause> list,
                                                      const Cause& cause) const {
  std::erase_if(list, [&](const FittedCause& c) { return c.cause.sameKind(cause); });
  list.push_back(fitValue(fine_, cause, {}));
  sortByProbability(list);
  return list;
}

void ForwardSelection::clear() {
  causes.clear();
  choices.clear();
  fine_.setBase({});
}

}  // namespace plumbline::gap
