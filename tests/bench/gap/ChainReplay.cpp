#include "ChainReplay.h"

#include <algorithm>
#include <cmath>

#include "gap/diagnosis/SensorChange.h"

namespace plumbline::bench {

using namespace gap;

ChainReplay::ChainReplay(const Evaluator& nominal, const ReplayOptions& steps)
    : nominal_(nominal), nominalPlant_(gap::nominalPlant(nominal.mechanism())), options_(steps) {
  findJoint();
  if (worst_ < 0) return;
  options_.joints = nominal_.jointsTouched({nullptr, {Site::joint, worst_, ""}, 0, 0});
  findRuns();
  for (const std::size_t t : runs_)
    before_.push_back(predict(t, plantOf(*nominal_.evidence().trials()[t].robot, {})));
}

void ChainReplay::findJoint() {
  const auto& trials = nominal_.evidence().trials();
  std::vector<double> squares(nominal_.mechanism().joints.size(), 0);
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Signal& signal = trials[t].signals[s];
      const double chi = nominal_.chi(t, s);
      if (trials[t].freeBase || signal.kind != SignalKind::position || !std::isfinite(chi)) continue;
      squares[static_cast<std::size_t>(signal.joint)] += chi;
    }
  const auto most = std::ranges::max_element(squares);
  if (most == squares.end() || *most <= 0) return;
  worst_ = static_cast<int>(most - squares.begin());
  const int driver = nominal_.mechanism().joints[static_cast<std::size_t>(worst_)].driver;
  if (driver >= 0) worst_ = driver;
}

void ChainReplay::findRuns() {
  const auto& trials = nominal_.evidence().trials();
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].freeBase) continue;
    double sum = 0;
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Signal& signal = trials[t].signals[s];
      const bool near = std::ranges::find(options_.joints, signal.joint) != options_.joints.end();
      if (near && std::isfinite(nominal_.chi(t, s))) sum += nominal_.chi(t, s);
    }
    order.emplace_back(-sum, t);
  }
  std::ranges::sort(order);
  for (const auto& [sum, t] : order)
    if (runs_.size() < 2 &&
        std::ranges::none_of(runs_, [&, t = t](std::size_t r) { return isRepeat(trials[r], trials[t]); }))
      runs_.push_back(t);
}

Prediction ChainReplay::predict(std::size_t t, const Plant& plant) const {
  const Trial& trial = nominal_.evidence().trials()[t];
  Prediction predicted = replay(plant, trial, options_);
  Prediction sensors = sensorChange(nominalPlant_, plant, trial, nominal_.basePrediction(t));
  for (std::size_t s = 0; s < trial.signals.size(); ++s)
    if (!sensors.values[s].empty()) predicted.values[s] = std::move(sensors.values[s]);
  return predicted;
}

ChainReplay::Squares ChainReplay::of(const Explanation& causes) const {
  constexpr double ranAway = 1e3;  // a replay that is no number counts as far off, not as lost
  const Evidence& data = nominal_.evidence();
  Squares result;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const std::size_t t = runs_[i];
    const Trial& trial = data.trials()[t];
    const Prediction predicted = predict(t, plantOf(*trial.robot, causes));
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const std::vector<double>&now = predicted.values[s], &then = before_[i].values[s];
      if (now.empty()) continue;
      const std::vector<double>& weights = data.weights(t, s);
      for (std::size_t k = 0; k < now.size(); ++k) {
        if (!(weights[k] > 0)) continue;
        const bool lost = !std::isfinite(now[k]);
        const double r = lost ? ranAway : trial.signals[s].values[k] - now[k];
        const double d = lost ? ranAway : now[k] - then[k];
        (Evidence::forFitting(data.block(t, k)) ? result.fitting : result.judging) += weights[k] * r * r;
        result.change += weights[k] * d * d;
      }
    }
  }
  return result;
}

}  // namespace plumbline::bench
