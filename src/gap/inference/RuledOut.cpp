#include "gap/inference/RuledOut.h"

#include <algorithm>
#include <cmath>

#include "gap/inference/Score.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr int mostHalved = 5;  // times, a start in proportion to which the replay changes

double strengthOf(const Cause& cause) { return cause.effect->strengthOf(cause.value); }

/// The starts of a kind whose strengths have one sign, the weakest first.
std::vector<Cause> startsOfSign(const Mechanism& robot, const Cause& kind, double sign) {
  std::vector<Cause> starts = startsOf(robot, kind);
  std::erase_if(starts, [&](const Cause& start) { return sign * strengthOf(start) <= 0; });
  std::ranges::stable_sort(starts, {}, [](const Cause& start) { return std::abs(strengthOf(start)); });
  return starts;
}

}  // namespace

RuledOut::RuledOut(const Replayer& replayer, const std::vector<Cause>& kinds,
                   const std::function<void(double)>& progress)
    : replayer_(replayer),
      left_(replayer.residuals({})),
      shares_(sharesOf(replayer.groups(), left_)),
      nominal_(densities(replayer.groups(), left_, shares_)),
      price_(priceOf(1, kinds.size())) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (progress) progress(static_cast<double>(i) / static_cast<double>(kinds.size()));
    for (const double sign : {1.0, -1.0}) {
      const std::vector<Cause> starts = startsOfSign(replayer_.mechanism(), kinds[i], sign);
      const auto first = std::ranges::find_if(starts, [&](const Cause& start) { return fallsBelow(start); });
      if (first != starts.end()) limits_.push_back({*first, weakerThan(*first)});
    }
  }
}

// Group by group, because one recording mostly suffices.
bool RuledOut::fallsBelow(const Cause& start) const {
  double change = 0;
  for (std::size_t g = 0; g < nominal_.size() && change >= -price_; ++g) {
    std::vector<char> wanted(nominal_.size(), 0);
    wanted[g] = 1;
    change += densityOn(replayer_, shares_, {start}, wanted) - nominal_[g];
  }
  return change < -price_;
}

std::optional<Cause> RuledOut::weakerThan(const Cause& start) const {
  if (!start.effect->linear) return std::nullopt;
  const Residuals with = replayer_.residuals({start});
  const auto gainOf = [&](double share) {
    double gain = 0;
    for (std::size_t c = 0; c < replayer_.groups().cells().size(); ++c) {
      const Cell& cell = replayer_.groups().cells()[c];
      if (with[cell.trial][cell.signal] == left_[cell.trial][cell.signal]) continue;
      const std::vector<double> there = residualsOf(cell, with);
      std::vector<double> r = residualsOf(cell, left_);
      for (std::size_t k = 0; k < r.size(); ++k) r[k] += share * (there[k] - r[k]);
      gain += stretchDensity(split(r), cell.noise, shares_[c]) - densityOf(cell, left_, shares_[c]);
    }
    return gain;
  };
  double best = price_ / 2, bestShare = 0;
  for (int halved = 1; halved <= mostHalved; ++halved) {
    const double share = std::ldexp(1, -halved);
    if (const double gain = gainOf(share); gain > best) best = gain, bestShare = share;
  }
  if (bestShare == 0) return std::nullopt;
  return withStrength(replayer_.mechanism(), start, bestShare * strengthOf(start));
}

std::optional<Cause> RuledOut::startFor(const Cause& start) const {
  constexpr double rounding = 1e-6;  // of a strength
  const double strength = strengthOf(start);
  for (const Limit& limit : limits_) {
    const double least = strengthOf(limit.ruledOut);
    if (!limit.ruledOut.sameForm(start) || least * strength <= 0) continue;
    if (std::abs(strength) >= (1 - rounding) * std::abs(least)) return limit.weaker;
  }
  return start;
}

}  // namespace plumbline::gap
