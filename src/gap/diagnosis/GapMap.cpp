#include "gap/diagnosis/GapMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace plumbline::gap {

std::vector<GapCell> gapCells(const Evaluator& evaluator) {
  struct Sum {
    double squares = 0, noise = 0, weighted = 0;
    std::size_t n = 0;
  };
  const Evidence& data = evaluator.evidence();
  std::map<std::string, std::array<Sum, numPhases>> sums;
  double whole = 0;
  for (std::size_t t = 0; t < data.trials().size(); ++t) {
    const Trial& trial = data.trials()[t];
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const Signal& signal = trial.signals[s];
      const auto& predicted = evaluator.basePrediction(t).values[s];
      if (!Evidence::counts(signal) || predicted.empty()) continue;
      const std::vector<Phase> phases = phasesOf(trial, signal);
      std::array<Sum, numPhases>& perPhase = sums[signal.name];
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double r) {
        Sum& sum = perPhase[static_cast<std::size_t>(phases[k])];
        sum.squares += r * r;
        sum.noise += 1 / w;
        sum.weighted += w * r * r;
        ++sum.n;
      });
    }
  }
  std::vector<GapCell> cells;
  std::vector<double> excess;
  for (const auto& [name, phases] : sums)
    for (std::size_t p = 0; p < numPhases; ++p) {
      const Sum& sum = phases[p];
      if (sum.n == 0) continue;
      const auto n = static_cast<double>(sum.n);
      cells.push_back({name, static_cast<Phase>(p), std::sqrt(sum.squares / n), std::sqrt(sum.noise / n),
                       std::max(0.0, sum.weighted - n), sum.n});
      whole += cells.back().share;
    }
  for (GapCell& cell : cells) cell.share = whole > 0 ? cell.share / whole : 0;
  std::stable_sort(cells.begin(), cells.end(),
                   [](const GapCell& a, const GapCell& b) { return a.share > b.share; });
  return cells;
}

std::vector<GapTrack> gapTracks(const Evaluator& evaluator) {
  const Evidence& data = evaluator.evidence();
  std::vector<GapTrack> tracks;
  for (std::size_t t = 0; t < data.trials().size(); ++t) {
    const Trial& trial = data.trials()[t];
    GapTrack track;
    track.trial = t;
    const std::size_t first = data.block(t, 0);
    for (std::size_t k = 0; k < trial.cycles(); ++k)
      while (track.start.size() <= data.block(t, k) - first) track.start.push_back(trial.time[k]);
    track.size.assign(track.start.size(), 0);
    std::vector<double> counts(track.start.size(), 0);
    for (std::size_t s = 0; s < trial.signals.size(); ++s)
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double r) {
        const std::size_t b = data.block(t, k) - first;
        track.size[b] += w * r * r;
        ++counts[b];
      });
    for (std::size_t b = 0; b < counts.size(); ++b)
      track.size[b] = counts[b] > 0 ? std::sqrt(track.size[b] / counts[b]) : 0;
    tracks.push_back(std::move(track));
  }
  return tracks;
}

std::vector<SignalGap> signalGaps(const Evaluator& evaluator, const std::vector<Prediction>& before) {
  struct Sum {
    double before = 0, after = 0, noise = 0, n = 0;
  };
  const Evidence& data = evaluator.evidence();
  std::map<std::string, Sum> sums;
  for (std::size_t t = 0; t < data.trials().size(); ++t) {
    const Trial& trial = data.trials()[t];
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const auto &a = before[t].values[s], &b = evaluator.basePrediction(t).values[s];
      if (!Evidence::counts(trial.signals[s]) || a.empty() || b.empty()) continue;
      Sum& sum = sums[trial.signals[s].name];
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double after) {
        const double from = trial.signals[s].values[k] - a[k];
        if (Evidence::forFitting(data.block(t, k)) || !std::isfinite(from)) return;
        sum.before += from * from;
        sum.after += after * after;
        sum.noise += 1 / w;
        ++sum.n;
      });
    }
  }
  std::vector<SignalGap> gaps;
  for (const auto& [name, sum] : sums)
    if (sum.n > 0)
      gaps.push_back(
          {name, std::sqrt(sum.before / sum.n), std::sqrt(sum.after / sum.n), std::sqrt(sum.noise / sum.n)});
  return gaps;
}

}  // namespace plumbline::gap
