#include "gap/diagnosis/Proposals.h"

#include <algorithm>
#include <utility>

#include "gap/diagnosis/AcceptanceTest.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/DeviatingJoints.h"
#include "gap/diagnosis/LostCycles.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/Probability.h"
#include "gap/replay/Ensemble.h"

namespace plumbline::gap {

namespace {

constexpr double limitCyclePrice =
    0.1;                              // of its gain: what a cause in doubt has to gain beyond a definite one
constexpr double coarseWithin = 1.2;  // of the squares with fine steps
constexpr double coarseAdds = 0.5;    // of what is unexplained, at most, where that is little

}  // namespace

std::vector<FittedCause> Proposals::find(const Look& look) {
  SearchOptions search_;
  search_.jobs = options_.jobs;
  search_.leastGain = look.leastGain;
  search_.progress = [&](double share) {
    if (options_.progress) options_.progress(look.stage, share);
  };
  SearchResult known;
  // A narrower search must not pass for the whole one of its base.
  SearchMemory* const memory = look.onlySensors || !look.lostCommands ? nullptr : look.memory;
  SearchStart start{fine_.base(), look.leastGain, {}};
  if (losesCommands(fine_.base())) start.lostCycles = fine_.lostCycles();
  if (auto remembered = memory ? memory->find(start) : std::nullopt) {
    known = std::move(*remembered);
    useLostCycles(known.lostCycles);
  } else {
    std::vector<Cause> possible = possibleCauses(fine_);
    if (look.onlySensors) std::erase_if(possible, [](const Cause& cause) { return !ofSensor(cause); });
    known.candidates = search(fine_, quickOn(fine_.base()), possible, search_);
    std::erase_if(known.candidates, [](const FittedCause& c) { return withinEngines(c.cause); });
    priceLimitCycles(known.candidates);
    if (look.lostCommands && !look.onlySensors) addLostCommands(known.candidates);
    known.lostCycles = fine_.lostCycles();
    // What goes on from here has what is remembered, no more.
    for (FittedCause& candidate : known.candidates) {
      Fit sums;
      sums.fitting = candidate.fit.fitting;
      sums.judging = candidate.fit.judging;
      candidate = {candidate.cause, std::move(sums), 0};
    }
    if (memory) memory->keep(start, known);
  }
  sortByProbability(known.candidates);
  return std::move(known.candidates);
}

/// An uncertain prediction fits more easily. So a cause that brings a limit cycle has to gain this much more
/// than one that brings none.
void Proposals::priceLimitCycles(std::vector<FittedCause>& list) const {
  const double before = fine_.baseFit().judging;
  for (FittedCause& candidate : list)
    if (anyLimitCycle(plantOf(fine_.mechanism(), {candidate.cause})))
      candidate.fit.judging += limitCyclePrice * std::max(0.0, before - candidate.fit.judging);
}

const Evaluator& Proposals::quickOn(const Explanation& base) {
  coarse_.setBase(base);
  const double adds = coarse_.baseFit().judging - fine_.baseFit().judging;
  const bool close = coarse_.baseFit().fitting <= coarseWithin * fine_.baseFit().fitting &&
                     (fine_.hasFloatingBase() || adds <= coarseAdds * excess(fine_));
  return close ? coarse_ : fine_;
}

void Proposals::useLostCycles(const std::vector<std::vector<std::uint8_t>>& cycles) {
  fine_.setLostCycles(cycles);
  coarse_.setLostCycles(cycles);
}

void Proposals::addLostCommands(std::vector<FittedCause>& list) {
  const auto dropout = std::ranges::find(effects(), true, &Effect::decoded);
  if (dropout == effects().end()) return;
  if (!mostDeviates(fine_) || losesCommands(fine_.base())) return;
  const LostCycles lost = findLostCycles(fine_.evidence(), fine_.base(), options_.jobs);
  if (lost.found < LostCycles::minCount) return;
  useLostCycles(lost.cycles);
  FittedCause candidate;
  candidate.cause = {*dropout, {Site::everywhere, -1, "*"}, lost.share, 0};
  candidate.fit = fine_.with(candidate.cause);
  candidate.fit.judging += lost.price;
  list.push_back(std::move(candidate));
}

}  // namespace plumbline::gap
