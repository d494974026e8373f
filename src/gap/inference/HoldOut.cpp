#include "gap/inference/HoldOut.h"

#include <algorithm>
#include <cmath>

#include "gap/diagnosis/Noise.h"
#include "gap/inference/Channels.h"

namespace plumbline::gap {

namespace {

struct Sum {
  double squares = 0, n = 0;
  void add(double r) {
    // A replay that diverged counts as a large error.
    squares += std::isfinite(r) ? r * r : 1e6;
    ++n;
  }
  double rms() const { return n > 0 ? std::sqrt(squares / n) : 0; }
};

/// All positions of a recording together.
void sumUp(RecordingLeft& left) {
  double before = 0, after = 0, floor = 0, noise = 0, n = 0, floors = 0;
  for (const SignalLeft& s : left.signals) {
    if (!s.position) continue;
    before += s.samples * s.before * s.before;
    after += s.samples * s.after * s.after;
    noise += s.samples * s.noise * s.noise;
    n += s.samples;
    if (s.hasFloor) floor += s.samples * s.floor * s.floor, floors += s.samples;
  }
  if (n == 0) return;
  left.before = std::sqrt(before / n);
  left.after = std::sqrt(after / n);
  left.noise = std::sqrt(noise / n);
  left.hasFloor = floors > 0;
  left.floor = floors > 0 ? std::sqrt(floor / floors) : 0;
}

}  // namespace

RecordingLeft leftIn(const Trial& trial, const std::vector<From>& causes) {
  return leftIn(trial, replay(plantOf(trial, {}), trial), causes);
}

RecordingLeft leftIn(const Trial& trial, const Prediction& nominal, const std::vector<From>& causes) {
  RecordingLeft left;
  left.folder = trial.recording;
  left.fellBefore = nominal.fell;
  std::vector<Prediction> corrected;
  for (const From& from : causes) {
    corrected.push_back(replay(plantOf(trial, from.causes), trial));
    left.fellAfter = left.fellAfter || corrected.back().fell;
  }
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    const Signal& signal = trial.signals[s];
    if (nominal.values[s].empty()) continue;
    Sum before, after;
    for (std::size_t part = 0; part < causes.size(); ++part) {
      const std::size_t to = part + 1 < causes.size() ? causes[part + 1].cycle : trial.cycles();
      for (std::size_t k = causes[part].cycle; k < to; ++k) {
        // Cycles that the replay has no reading for (current without a constant) are not compared.
        if (!std::isfinite(signal.values[k]) || std::isnan(nominal.values[s][k])) continue;
        before.add(signal.values[k] - nominal.values[s][k]);
        after.add(signal.values[k] - corrected[part].values[s][k]);
      }
    }
    if (before.n == 0) continue;
    left.signals.push_back(
        {signal.name, signal.kind == SignalKind::position, before.rms(), after.rms(), 0, false, before.n, 0});
  }
  sumUp(left);
  return left;
}

RecordingLeft together(const std::vector<RecordingLeft>& parts) {
  RecordingLeft all = parts.front();
  for (SignalLeft& signal : all.signals) {
    double before = 0, after = 0, n = 0;
    for (const RecordingLeft& part : parts)
      for (const SignalLeft& other : part.signals) {
        if (other.signal != signal.signal) continue;
        before += other.samples * other.before * other.before;
        after += other.samples * other.after * other.after;
        n += other.samples;
      }
    signal.before = std::sqrt(before / n);
    signal.after = std::sqrt(after / n);
    signal.samples = n;
  }
  for (const RecordingLeft& part : parts) {
    all.fellBefore = all.fellBefore || part.fellBefore;
    all.fellAfter = all.fellAfter || part.fellAfter;
  }
  sumUp(all);
  return all;
}

void putFloors(const std::vector<Trial>& trials, std::vector<RecordingLeft>& recordings) {
  for (RecordingLeft& left : recordings) {
    for (SignalLeft& signal : left.signals) {
      Sum floor;
      for (const Trial& a : trials)
        for (const Trial& b : trials) {
          if (a.recording != left.folder || b.recording == a.recording || !isRepeat(a, b)) continue;
          for (const Signal& x : a.signals)
            for (const Signal& y : b.signals)
              for (std::size_t k = 0;
                   x.name == signal.signal && y.name == x.name && k < std::min(a.cycles(), b.cycles()); ++k)
                if (std::isfinite(x.values[k] - y.values[k]))
                  floor.add((x.values[k] - y.values[k]) / std::sqrt(2.0));
        }
      signal.hasFloor = floor.n > 0;
      signal.floor = floor.rms();
    }
    sumUp(left);
  }
}

void putNoise(const std::vector<Trial>& trials, std::vector<RecordingLeft>& recordings) {
  const std::vector<std::vector<ChannelUse>> uses = channelUses(trials);
  for (RecordingLeft& left : recordings) {
    for (std::size_t t = 0; t < trials.size(); ++t)
      for (std::size_t s = 0; s < trials[t].signals.size() && trials[t].recording == left.folder; ++s)
        for (SignalLeft& signal : left.signals)
          if (signal.signal == trials[t].signals[s].name) signal.noise = uses[t][s].noise;
    sumUp(left);
  }
}

double meanClosed(const std::vector<RecordingLeft>& recordings) {
  double sum = 0;
  for (const RecordingLeft& left : recordings) sum += left.closed();
  return recordings.empty() ? 0 : sum / static_cast<double>(recordings.size());
}

double meanClosedToNoise(const std::vector<RecordingLeft>& recordings) {
  double sum = 0;
  for (const RecordingLeft& left : recordings) sum += left.closedToNoise();
  return recordings.empty() ? 0 : sum / static_cast<double>(recordings.size());
}

}  // namespace plumbline::gap
