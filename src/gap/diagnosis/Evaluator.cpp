#include "gap/diagnosis/Evaluator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gap/diagnosis/SensorChange.h"
#include "gap/replay/Ensemble.h"

namespace plumbline::gap {

namespace {

/// What doubt in a prediction costs: a wide guess is right more often and worth less.
double doubt(double own, double weight) { return weight == own ? 0 : std::log(own / weight); }

/// On a floating base, a foot that slips or lands a moment too late changes the rest of the run. So beyond a
/// limit the squares of a block count by their logarithm.
class Squares {
public:
  explicit Squares(bool freeBase_) : freeBase(freeBase_) {}
  void add(double square) { sum += square, ++n; }
  double mean() const { return sum / n; }
  bool empty() const { return n == 0; }
  double counted() const { return isFar() ? n * limit * (1 + std::log(sum / (n * limit))) : sum; }
  /// Change of counted() for a change of the squares.
  double slope() const { return isFar() ? n * limit / sum : 1; }

private:
  static constexpr double limit = 25;  // noise variances, on average over the block
  bool isFar() const { return freeBase && sum > n * limit; }

  double sum = 0, n = 0;
  bool freeBase;
};

/// Mean square of a walk's half-seconds without the worst sixth: a step that lands in another way in the
/// replay spoils the rest of its piece, and says nothing about what is wrong in all the others.
double meanWithoutWorst(const std::vector<Squares>& blocks) {
  constexpr double worst = 1 / 6.0;
  std::vector<double> means;
  for (const Squares& block : blocks)
    if (!block.empty()) means.push_back(block.mean());
  if (means.empty()) return std::nan("");
  std::ranges::sort(means);
  means.resize(means.size() - static_cast<std::size_t>(worst * static_cast<double>(means.size())));
  return std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size());
}

/// Mean weighted square of a joint's residuals, but for what a constant lead or lag of up to 0.2 ms explains:
/// the explicit steps of one engine put a motion ahead of the implicit ones of another (measured 0.14 ms for
/// steps of 0.2 ms).
class MeanBesideLead {
public:
  MeanBesideLead(const Trial& trial_, const Signal& signal_)
      : trial(trial_), signal(signal_), moves(signal_.kind == SignalKind::position && !trial_.freeBase) {}
  void add(std::size_t k, double w, double r) {
    const double v = moves ? rateAt(trial, signal, k) : 0;
    rr += w * r * r, rv += w * r * v, vv += w * v * v, ++n;
  }
  double mean() const {
    const double lead = vv > 0 ? std::clamp(rv / vv, -most, most) : 0;
    return n > 0 ? (rr - lead * (2 * rv - lead * vv)) / n : std::nan("");
  }

private:
  static constexpr double most = 2e-4;  // [s]

  const Trial& trial;
  const Signal& signal;
  const bool moves;
  double rr = 0, rv = 0, vv = 0, n = 0;
};

/// Puts the signals that were replayed in the place of those that were there.
void takeOver(Prediction&& fresh, Prediction& all) {
  for (std::size_t s = 0; s < fresh.values.size(); ++s) {
    if (fresh.values[s].empty()) continue;
    all.values[s] = std::move(fresh.values[s]);
    if (fresh.scatter.empty() && all.scatter.empty()) continue;
    all.scatter.resize(all.values.size());
    all.scatter[s] = fresh.scatter.empty() ? std::vector<double>() : std::move(fresh.scatter[s]);
  }
}

}  // namespace

Evaluator::Evaluator(const Mechanism& mechanism, const Evidence& evidence, const ReplayOptions& accuracy_)
    : robot(mechanism), data(evidence), accuracy(accuracy_) {
  for (const Trial& trial : data.trials()) (trial.freeBase ? standingRuns : heldRuns) = true;
  lost.resize(data.trials().size());
  setBase({});
}

ReplayOptions Evaluator::optionsOf(std::size_t trial, const Explanation& explanation) const {
  ReplayOptions options = accuracy;
  if (losesCommands(explanation) && !lost[trial].empty()) options.lostCycles = &lost[trial];
  return options;
}

void Evaluator::setLostCycles(std::vector<std::vector<std::uint8_t>> cycles) {
  if (cycles == lost) return;
  lost = std::move(cycles);
  if (!losesCommands(causes)) return;
  predictions.clear();  // all of them, not only what other causes would change
  setBase(Explanation(causes));
}

void Evaluator::leaveFloatingBaseOut(bool out) {
  standingOut = out;
  predictions.clear();
  setBase({});
}

std::vector<int> Evaluator::chainsThatDiffer(const Explanation& other) const {
  std::vector<int> joints;
  for (const auto& [one, two] : {std::pair(&causes, &other), std::pair(&other, &causes)})
    for (const Cause& cause : *one) {
      if (std::ranges::find(*two, cause) != two->end()) continue;
      std::vector<int> touched = jointsTouched(cause);
      // Any chain will do for readings of the body.
      if (touched.empty()) touched = jointsTouched({nullptr, {Site::joint, 0, ""}, 0, 0});
      for (const int joint : touched)
        if (std::ranges::find(joints, joint) == joints.end()) joints.push_back(joint);
    }
  std::ranges::sort(joints);
  return joints;
}

void Evaluator::replayBase(const Explanation& explanation) {
  const bool partly = !predictions.empty();
  const std::vector<int> joints = chainsThatDiffer(explanation);
  causes = explanation;
  if (partly && joints.empty()) return;
  predictions.resize(data.trials().size());
  basePlants.clear();
  for (std::size_t t = 0; t < predictions.size(); ++t) {
    const Trial& trial = data.trials()[t];
    basePlants.push_back(plantOf(trial, causes));
    if (leftOut(t)) {
      predictions[t].values.resize(trial.signals.size());
      continue;
    }
    ReplayOptions options = optionsOf(t, causes);
    if (partly && !trial.freeBase) options.joints = joints;
    Prediction fresh = predictEnsemble(basePlants[t], trial, options);
    if (options.joints.empty()) {
      predictions[t] = std::move(fresh);
      continue;
    }
    takeOver(std::move(fresh), predictions[t]);
  }
}

void Evaluator::setBase(const Explanation& explanation) {
  replayBase(explanation);
  chis.clear();
  baseSquares = {};
  baseSquares.squares.assign(data.numBlocks(), 0);
  for (std::size_t t = 0; t < predictions.size(); ++t) {
    const Trial& trial = data.trials()[t];
    auto& perSignal = chis.emplace_back(trial.signals.size(), std::nan(""));
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const auto& predicted = predictions[t].values[s];
      if (predicted.empty()) continue;
      MeanBesideLead mean(trial, trial.signals[s]);
      const std::vector<double>& weights = data.weights(t, s);
      const std::size_t first = data.block(t, 0);
      std::vector<Squares> blocks(data.block(t, trial.cycles() - 1) - first + 1, Squares(trial.freeBase));
      data.forEach(t, s, predictions[t], [&](std::size_t k, double w, double r) {
        const std::size_t b = data.block(t, k);
        blocks[b - first].add(w * r * r);
        baseSquares.squares[b] += doubt(weights[k], w);
        mean.add(k, w, r);
      });
      for (std::size_t b = 0; b < blocks.size(); ++b) baseSquares.squares[first + b] += blocks[b].counted();
      perSignal[s] = trial.restarts.empty() ? mean.mean() : meanWithoutWorst(blocks);
    }
  }
  for (std::size_t b = 0; b < data.numBlocks(); ++b)
    (Evidence::forFitting(b) ? baseSquares.fitting : baseSquares.judging) += baseSquares.squares[b];
}

std::vector<int> Evaluator::jointsTouched(const Cause& cause) const {
  const Place& place = cause.place;
  std::vector<int> all(robot.joints.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  if (place.site == Site::everywhere) return all;
  if (place.site == Site::imu || place.site == Site::foot || place.site == Site::ground) return {};
  const auto rootOf = [&](int joint) {
    const std::vector<int> chain = robot.chain(robot.joints[static_cast<std::size_t>(joint)].child);
    return chain.empty() ? joint : chain.front();
  };
  std::vector<int> roots;
  if (place.site == Site::joint) {
    for (const int joint : all)
      if (robot.motorOf(joint) == robot.motorOf(place.index)) roots.push_back(rootOf(joint));
  } else {
    const std::vector<int> chain = robot.chain(place.index);
    if (chain.empty()) return {};
    roots.push_back(chain.front());
  }
  std::vector<int> touched;
  for (const int joint : all)
    if (std::ranges::find(roots, rootOf(joint)) != roots.end()) touched.push_back(joint);
  return touched;
}

Prediction Evaluator::changed(std::size_t t, const Cause& cause) const {
  const Trial& trial = data.trials()[t];
  if (!inForce(cause, trial)) return {};
  Plant plant = basePlants[t];
  cause.effect->apply(plant, cause.place, cause.value, cause.variant);
  if (cause.place.site == Site::imu || cause.place.site == Site::foot) {
    return sensorChange(basePlants[t], plant, trial, predictions[t]);
  }
  ReplayOptions options = accuracy;
  if (!trial.freeBase) {
    options.joints = jointsTouched(cause);
    if (options.joints.empty()) return {};
  }
  if ((cause.effect->decoded || losesCommands(causes)) && !lost[t].empty()) options.lostCycles = &lost[t];
  return predictEnsemble(plant, trial, options);
}

void Evaluator::addChange(const Prediction& candidate, std::size_t t, std::size_t s, Fit& fit) const {
  struct Block {
    explicit Block(bool freeBase) : before(freeBase), after(freeBase) {}
    Squares before, after;
    double doubt = 0, product = 0, change = 0;
  };
  const Trial& trial = data.trials()[t];
  const std::vector<double>&weights = data.weights(t, s), &predicted = candidate.values[s],
        &before = predictions[t].values[s];
  const std::size_t first = data.block(t, 0);
  std::vector<Block> blocks(data.block(t, trial.cycles() - 1) - first + 1, Block(trial.freeBase));
  data.forEach(t, s, predictions[t], [&](std::size_t k, double known, double r) {
    // A replay that ran away counts as far off, not as lost.
    const double d = std::isfinite(predicted[k]) ? predicted[k] - before[k] : 1e3;
    const double w = weights[k] * Evidence::certainty(candidate, s, k, weights[k]);
    Block& block = blocks[data.block(t, k) - first];
    block.before.add(known * r * r);
    block.after.add(w * (r - d) * (r - d));
    if (w != known) block.doubt += doubt(weights[k], w) - doubt(weights[k], known);
    block.product += w * r * d;
    block.change += w * d * d;
  });
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::size_t b = first + i;
    const Block& block = blocks[i];
    fit.squares[b] += block.after.counted() - block.before.counted() + block.doubt;
    if (!Evidence::forFitting(b)) continue;
    fit.product += block.before.slope() * block.product;
    fit.change += block.before.slope() * block.change;
  }
}

Fit Evaluator::compare(const std::vector<Prediction>& candidates) const {
  Fit fit;
  fit.squares = baseSquares.squares;
  for (std::size_t t = 0; t < candidates.size(); ++t) {
    if (candidates[t].values.empty()) continue;
    const Trial& trial = data.trials()[t];
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const auto& predicted = candidates[t].values[s];
      const auto& before = predictions[t].values[s];
      if (predicted.empty() || before.empty()) continue;
      addChange(candidates[t], t, s, fit);
    }
  }
  for (std::size_t b = 0; b < fit.squares.size(); ++b)
    (Evidence::forFitting(b) ? fit.fitting : fit.judging) += fit.squares[b];
  return fit;
}

double Evaluator::chi(std::size_t trial, std::size_t signal) const { return chis[trial][signal]; }

Fit Evaluator::with(const Cause& cause, const TrialMask& mask) const {
  std::vector<Prediction> candidates(data.trials().size());
  for (std::size_t t = 0; t < candidates.size(); ++t) {
    if (leftOut(t) || (!mask.empty() && !mask[t])) continue;
    candidates[t] = changed(t, cause);
  }
  return compare(candidates);
}

std::vector<Prediction> Evaluator::played(const Explanation& explanation) const {
  const std::vector<int> joints = chainsThatDiffer(explanation);
  std::vector<Prediction> candidates(data.trials().size());
  for (std::size_t t = 0; t < candidates.size() && !joints.empty(); ++t) {
    if (leftOut(t)) continue;
    const Trial& trial = data.trials()[t];
    ReplayOptions options = optionsOf(t, explanation);
    if (!trial.freeBase) options.joints = joints;
    candidates[t] = predictEnsemble(plantOf(trial, explanation), trial, options);
  }
  return candidates;
}

}  // namespace plumbline::gap
