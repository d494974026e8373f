#include "gap/inference/Replayer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "framework/Parallel.h"

namespace plumbline::gap {

namespace {

constexpr double mostLead = 2e-4;        // of a position [s]
constexpr double mostDutyLead = 1.5e-3;  // a servo's control cycle, at whose begin it worked a duty out [s]
constexpr std::size_t mostKept = 40'000'000;  // numbers in the cache

bool mayLead(const Signal& signal) {
  return signal.kind == SignalKind::position || signal.kind == SignalKind::duty;
}

/// Per signal of a trial: its slope in each cycle, 0 in those that are not scored; empty where it does not
/// lead.
std::vector<std::vector<double>> ratesOf(const Trial& trial) {
  std::vector<std::vector<double>> rates;
  for (const Signal& signal : trial.signals) {
    auto& of = rates.emplace_back(mayLead(signal) ? trial.cycles() : 0, 0.0);
    for (std::size_t k = firstScored(trial); k < of.size(); ++k) of[k] = rateAt(trial, signal, k);
  }
  return rates;
}

/// Subtracts the part that a constant lead of the prediction explains.
void takeLeadOff(const Signal& signal, const std::vector<double>& rates, std::vector<double>& residual) {
  if (!mayLead(signal)) return;
  const double most = signal.kind == SignalKind::duty ? mostDutyLead : mostLead;
  double product = 0, squares = 0;
  for (std::size_t k = 0; k < residual.size(); ++k) {
    if (!std::isfinite(residual[k])) continue;
    product += residual[k] * rates[k];
    squares += rates[k] * rates[k];
  }
  if (!(squares > 0)) return;
  const double lead = std::clamp(product / squares, -most, most);
  for (std::size_t k = 0; k < residual.size(); ++k) residual[k] -= lead * rates[k];
}

}  // namespace

Replayer::Replayer(const Mechanism& robot, const Groups& groups, int jobs, const ReplayOptions& options,
                   Explanation base)
    : robot_(robot), data_(groups), threads_(jobs), accuracy_(options), fixed_(std::move(base)) {
  std::map<int, std::size_t> chainOfRoot;
  for (int joint = 0; joint < robot_.numJoints(); ++joint) {
    const std::vector<int> chain = robot_.chain(robot_.joints[static_cast<std::size_t>(joint)].child);
    const int root = chain.empty() ? joint : chain.front();
    const auto [at, fresh] = chainOfRoot.try_emplace(root, chainJoints_.size());
    if (fresh) chainJoints_.emplace_back();
    chainJoints_[at->second].push_back(joint);
  }
  std::vector<std::vector<std::vector<double>>> rates;
  for (const Trial& trial : groups.trials()) rates.push_back(ratesOf(trial));
  rates_ = std::make_shared<const std::vector<std::vector<std::vector<double>>>>(std::move(rates));
}

Replayer::Replayer(const Replayer& whole, const Groups& groups, Explanation base)
    : robot_(whole.robot_),
      data_(groups),
      threads_(whole.threads_),
      accuracy_(whole.accuracy_),
      fixed_(std::move(base)),
      chainJoints_(whole.chainJoints_),
      rates_(whole.rates_),
      memory_(whole.memory_) {}

bool Replayer::feels(std::size_t chain, const Cause& cause) const {
  const auto has = [&](int joint) {
    return std::ranges::find(chainJoints_[chain], joint) != chainJoints_[chain].end();
  };
  switch (cause.place.site) {
    case Site::everywhere:
      return true;
    case Site::joint:
      return std::ranges::any_of(chainJoints_[chain], [&](int joint) {
        return robot_.motorOf(joint) == robot_.motorOf(cause.place.index);
      });
    case Site::link: {
      const std::vector<int> carried = robot_.chain(cause.place.index);
      return !carried.empty() && has(carried.front());
    }
    default:
      return false;
  }
}

bool Replayer::hasBodySignals(std::size_t trial) const {
  return std::ranges::any_of(data_.trials()[trial].signals, [](const Signal& s) { return s.joint < 0; });
}

// With a fixed base there is one more: the readings of the body.
std::size_t Replayer::chainsOf(std::size_t trial) const {
  if (data_.trials()[trial].freeBase) return 1;
  return chainJoints_.size() + (hasBodySignals(trial) ? 1 : 0);
}

std::string Replayer::keyOf(std::size_t trial, std::size_t chain, const Explanation& causes) const {
  std::string key = std::to_string(trial) + ":" + std::to_string(chain);
  const bool whole = data_.trials()[trial].freeBase;
  for (const Cause& cause : causes) {
    const bool felt =
        whole || (chain < chainJoints_.size() ? feels(chain, cause) : cause.place.site == Site::imu);
    if (!felt || !inForce(cause, data_.trials()[trial])) continue;
    char text[64];
    std::snprintf(text, sizeof text, "/%d/%.17g", cause.variant, cause.value);
    key += "|" + std::string(cause.effect->id) + "@" + cause.place.at + cause.place.axis + text;
  }
  return key;
}

Replayer::Played Replayer::play(std::size_t t, std::size_t chain, const Explanation& causes) const {
  const Trial& trial = data_.trials()[t];
  const bool whole = trial.freeBase, body = !whole && chain == chainJoints_.size();
  ReplayOptions options = accuracy_;
  if (whole)
    options.gearStep = options.step;  // shorter steps would change all of a robot on its feet
  else
    options.joints = chainJoints_[body ? 0 : chain];
  const Plant plant = plantOf(trial, causes);
  const Prediction prediction = replay(plant, trial, options);
  auto played = std::make_shared<std::vector<std::pair<std::size_t, Series>>>();
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    const Signal& signal = trial.signals[s];
    if (prediction.values[s].empty() || (!whole && body != (signal.joint < 0))) continue;
    std::vector<double> residual(prediction.values[s].size());
    for (std::size_t k = 0; k < residual.size(); ++k) {
      const double predicted = prediction.values[s][k];
      const double r = signal.values[k] - predicted;
      // A replay that diverged is wrong, not missing. The duty of a motor that is off is not predicted, nor
      // an effort next to a gap in the measured angle.
      const bool missing = std::isnan(signal.values[k]) || isEffort(signal.kind);
      residual[k] = missing || std::isfinite(r) ? r : 1e6;
    }
    takeLeadOff(signal, (*rates_)[t][s], residual);
    played->emplace_back(s, std::make_shared<const ResidualSeries>(std::move(residual)));
  }
  return played;
}

Residuals Replayer::residuals(const Explanation& hypothesis, const std::vector<char>& wanted) const {
  Explanation causes = fixed_;
  causes.insert(causes.end(), hypothesis.begin(), hypothesis.end());
  std::vector<Task> tasks;
  const std::size_t count = data_.trials().size();
  for (std::size_t t = 0; t < count; ++t) {
    if (wanted.empty() ? !data_.holds(t) : !wanted[t]) continue;
    for (std::size_t chain = 0; chain < chainsOf(t); ++chain)
      tasks.push_back({t, chain, keyOf(t, chain, causes), {}});
  }
  std::vector<std::size_t> missing;
  auto& [mutex, cache, recent, kept, replays, asked] = *memory_;
  {
    const std::lock_guard lock(mutex);
    asked += tasks.size();
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const auto at = cache.find(tasks[i].key);
      if (at == cache.end()) {
        missing.push_back(i);
        continue;
      }
      tasks[i].played = at->second.first;
      recent.splice(recent.begin(), recent, at->second.second);
    }
  }
  parallel(missing.size(), threads_, [&](std::size_t i) {
    Task& task = tasks[missing[i]];
    task.played = play(task.trial, task.chain, causes);
  });
  const std::lock_guard lock(mutex);
  for (const std::size_t i : missing) {
    ++replays;
    if (cache.contains(tasks[i].key)) continue;
    recent.push_front(tasks[i].key);
    cache[tasks[i].key] = {tasks[i].played, recent.begin()};
    for (const auto& [s, series] : *tasks[i].played) kept += series->size();
  }
  while (kept > mostKept && recent.size() > 1) {
    const auto oldest = cache.find(recent.back());
    for (const auto& [s, series] : *oldest->second.first) kept -= series->size();
    cache.erase(oldest);
    recent.pop_back();
  }
  Residuals result(count);
  for (std::size_t t = 0; t < count; ++t) result[t].resize(data_.trials()[t].signals.size());
  for (const Task& task : tasks)
    for (const auto& [s, series] : *task.played) result[task.trial][s] = series;
  return result;
}

}  // namespace plumbline::gap
