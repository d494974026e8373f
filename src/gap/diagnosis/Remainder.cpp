#include "gap/diagnosis/Remainder.h"

#include <algorithm>

#include "gap/diagnosis/GapMeter.h"

namespace plumbline::gap {

namespace {

// In units of noise, and as shares of what was there.
constexpr double unexplainedShare = 0.2;
constexpr double remaining = 1.7,
                 remainingShare = 0.08;  // beyond these, an explanation is not the whole of it
constexpr double remainingOnFeet = 2.5, remainingShareOnFeet = 0.2;  // contacts differ more between engines

}  // namespace

Remainder::Remainder(const Evaluator& evaluator, double worstBefore)
    : held(worstGap(evaluator, false).size), onFeet(gapOnFeet(evaluator)), before(worstBefore) {}

double Remainder::unaccounted() const { return std::max(unaccountedHeld(), unaccountedOnFeet()); }
double Remainder::unaccountedHeld() const { return held / std::max(remaining, remainingShare * before); }
double Remainder::unaccountedOnFeet() const {
  return onFeet / std::max(remainingOnFeet, remainingShareOnFeet * before);
}

double Remainder::size() const { return std::max(held, onFeet); }
bool Remainder::little() const { return size() < unexplainedShare / 2 * before; }
bool Remainder::mayRemain(double times) const {
  return size() < times * std::max(unexplained, unexplainedShare * before);
}
bool Remainder::onlyOfSensors() const { return held < unexplained && onFeet < remainingOnFeet; }

}  // namespace plumbline::gap
