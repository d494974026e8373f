#include "gap/diagnosis/Evaluator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gap/diagnosis/SensorChange.h"
#include "gap/replay/Ensemble.h"

namespace plumbline::gap {

namespace {

/// The cost of uncertainty in a prediction: a wide guess is right more often and is worth less.
double doubt(double own, double weight) { return weight == own ? 0 : std::log(own / weight); }

/// On a floating base, a foot that slips or lands a moment too late changes the rest of the run. So beyond a
/// limit the squares of a block count by their logarithm.
class Squares {
public:
  explicit Squares(bool freeBase) : freeBase_(freeBase) {}
  void add(double square) { sum_ += square, ++n_; }
  double mean() const { return sum_ / n_; }
  bool empty() const { return n_ == 0; }
  double counted() const {
    return isFar() ? n_ * maxMeanSquare * (1 + std::log(sum_ / (n_ * maxMeanSquare))) : sum_;
  }
  /// Change of counted() for a change of the squares.
  double slope() const { return isFar() ? n_ * maxMeanSquare / sum_ : 1; }

private:
  static constexpr double maxMeanSquare = 25;  // noise variances, on average over the block
  bool isFar() const { return freeBase_ && sum_ > n_ * maxMeanSquare; }

  double sum_ = 0, n_ = 0;
  bool freeBase_;
};

/// Mean square of a walk's half-seconds without the worst sixth. A step that lands differently in the replay
/// spoils the rest of its piece, and says nothing about errors in all the others.
double meanWithoutWorst(const std::vector<Squares>& blocks) {
  constexpr double leftOutShare = 1 / 6.0;
  std::vector<double> means;
  for (const Squares& block : blocks)
    if (!block.empty()) means.push_back(block.mean());
  if (means.empty()) return std::nan("");
  std::ranges::sort(means);
  means.resize(means.size() - static_cast<std::size_t>(leftOutShare * static_cast<double>(means.size())));
  return std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size());
}

/// Mean weighted square of a joint's residuals, without the part that a constant lead or lag of up to 0.2 ms
/// explains. The explicit steps of one engine are ahead of the implicit ones of another (measured 0.14 ms for
/// steps of 0.2 ms).
class MeanWithoutLead {
public:
  MeanWithoutLead(const Trial& trial, const Signal& signal)
      : trial_(trial), signal_(signal), moves_(signal.kind == SignalKind::position && !trial.freeBase) {}
  void add(std::size_t k, double w, double r) {
    const double v = moves_ ? rateAt(trial_, signal_, k) : 0;
    rr_ += w * r * r, rv_ += w * r * v, vv_ += w * v * v, ++n_;
  }
  double mean() const {
    const double lead = vv_ > 0 ? std::clamp(rv_ / vv_, -maxLead, maxLead) : 0;
    return n_ > 0 ? (rr_ - lead * (2 * rv_ - lead * vv_)) / n_ : std::nan("");
  }

private:
  static constexpr double maxLead = 2e-4;  // [s]

  const Trial& trial_;
  const Signal& signal_;
  const bool moves_;
  double rr_ = 0, rv_ = 0, vv_ = 0, n_ = 0;
};

/// Replaces the signals that were replayed.
void takeOver(Prediction&& fresh, Prediction& all) {
  for (std::size_t s = 0; s < fresh.values.size(); ++s) {
    if (fresh.values[s].empty()) continue;
    all.values[s] = std::move(fresh.values[s]);
    if (fresh.variance.empty() && all.variance.empty()) continue;
    all.variance.resize(all.values.size());
    all.variance[s] = fresh.variance.empty() ? std::vector<double>() : std::move(fresh.variance[s]);
  }
}

}  // namespace

Evaluator::Evaluator(const Mechanism& mechanism, const Evidence& evidence, const ReplayOptions& accuracy)
    : robot_(mechanism), data_(evidence), accuracy_(accuracy) {
  for (const Trial& trial : data_.trials()) (trial.freeBase ? floatingBaseRuns_ : fixedBaseRuns_) = true;
  lost_.resize(data_.trials().size());
  setBase({});
}

ReplayOptions Evaluator::optionsOf(std::size_t trial, const Explanation& explanation) const {
  ReplayOptions options = accuracy_;
  if (losesCommands(explanation) && !lost_[trial].empty()) options.lostCycles = &lost_[trial];
  return options;
}

void Evaluator::setLostCycles(std::vector<std::vector<std::uint8_t>> cycles) {
  if (cycles == lost_) return;
  lost_ = std::move(cycles);
  if (!losesCommands(causes_)) return;
  predictions_.clear();  // all of them, not only what other causes would change
  setBase(Explanation(causes_));
}

void Evaluator::leaveFloatingBaseOut(bool out) {
  floatingBaseLeftOut_ = out;
  predictions_.clear();
  setBase({});
}

std::vector<int> Evaluator::chainsThatDiffer(const Explanation& other) const {
  std::vector<int> joints;
  for (const auto& [one, two] : {std::pair(&causes_, &other), std::pair(&other, &causes_)})
    for (const Cause& cause : *one) {
      if (std::ranges::find(*two, cause) != two->end()) continue;
      std::vector<int> touched = jointsTouched(cause);
      // Any chain is enough for readings of the body.
      if (touched.empty()) touched = jointsTouched({nullptr, {Site::joint, 0, ""}, 0, 0});
      for (const int joint : touched)
        if (std::ranges::find(joints, joint) == joints.end()) joints.push_back(joint);
    }
  std::ranges::sort(joints);
  return joints;
}

void Evaluator::replayBase(const Explanation& explanation) {
  const bool partly = !predictions_.empty();
  const std::vector<int> joints = chainsThatDiffer(explanation);
  causes_ = explanation;
  if (partly && joints.empty()) return;
  predictions_.resize(data_.trials().size());
  basePlants_.clear();
  for (std::size_t t = 0; t < predictions_.size(); ++t) {
    const Trial& trial = data_.trials()[t];
    basePlants_.push_back(plantOf(trial, causes_));
    if (leftOut(t)) {
      predictions_[t].values.resize(trial.signals.size());
      continue;
    }
    ReplayOptions options = optionsOf(t, causes_);
    if (partly && !trial.freeBase) options.joints = joints;
    Prediction fresh = predictEnsemble(basePlants_[t], trial, options);
    if (options.joints.empty()) {
      predictions_[t] = std::move(fresh);
      continue;
    }
    takeOver(std::move(fresh), predictions_[t]);
  }
}

void Evaluator::setBase(const Explanation& explanation) {
  replayBase(explanation);
  chis_.clear();
  baseSquares_ = {};
  baseSquares_.squares.assign(data_.numBlocks(), 0);
  for (std::size_t t = 0; t < predictions_.size(); ++t) {
    const Trial& trial = data_.trials()[t];
    auto& perSignal = chis_.emplace_back(trial.signals.size(), std::nan(""));
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const auto& predicted = predictions_[t].values[s];
      if (predicted.empty()) continue;
      MeanWithoutLead mean(trial, trial.signals[s]);
      const std::vector<double>& weights = data_.weights(t, s);
      const std::size_t first = data_.block(t, 0);
      std::vector<Squares> blocks(data_.block(t, trial.cycles() - 1) - first + 1, Squares(trial.freeBase));
      data_.forEach(t, s, predictions_[t], [&](std::size_t k, double w, double r) {
        const std::size_t b = data_.block(t, k);
        blocks[b - first].add(w * r * r);
        baseSquares_.squares[b] += doubt(weights[k], w);
        mean.add(k, w, r);
      });
      for (std::size_t b = 0; b < blocks.size(); ++b) baseSquares_.squares[first + b] += blocks[b].counted();
      perSignal[s] = trial.restarts.empty() ? mean.mean() : meanWithoutWorst(blocks);
    }
  }
  for (std::size_t b = 0; b < data_.numBlocks(); ++b)
    (Evidence::forFitting(b) ? baseSquares_.fitting : baseSquares_.judging) += baseSquares_.squares[b];
}

std::vector<int> Evaluator::jointsTouched(const Cause& cause) const {
  const Place& place = cause.place;
  std::vector<int> all(robot_.joints.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  if (place.site == Site::everywhere) return all;
  if (place.site == Site::imu || place.site == Site::foot || place.site == Site::ground) return {};
  const auto rootOf = [&](int joint) {
    const std::vector<int> chain = robot_.chain(robot_.joints[static_cast<std::size_t>(joint)].child);
    return chain.empty() ? joint : chain.front();
  };
  std::vector<int> roots;
  if (place.site == Site::joint) {
    for (const int joint : all)
      if (robot_.motorOf(joint) == robot_.motorOf(place.index)) roots.push_back(rootOf(joint));
  } else {
    const std::vector<int> chain = robot_.chain(place.index);
    if (chain.empty()) return {};
    roots.push_back(chain.front());
  }
  std::vector<int> touched;
  for (const int joint : all)
    if (std::ranges::find(roots, rootOf(joint)) != roots.end()) touched.push_back(joint);
  return touched;
}

Prediction Evaluator::changed(std::size_t t, const Cause& cause) const {
  const Trial& trial = data_.trials()[t];
  if (!inForce(cause, trial)) return {};
  Plant plant = basePlants_[t];
  cause.effect->apply(plant, cause.place, cause.value, cause.variant);
  if (cause.place.site == Site::imu || cause.place.site == Site::foot) {
    return sensorChange(basePlants_[t], plant, trial, predictions_[t]);
  }
  ReplayOptions options = accuracy_;
  if (!trial.freeBase) {
    options.joints = jointsTouched(cause);
    if (options.joints.empty()) return {};
  }
  if ((cause.effect->decoded || losesCommands(causes_)) && !lost_[t].empty()) options.lostCycles = &lost_[t];
  return predictEnsemble(plant, trial, options);
}

void Evaluator::addChange(const Prediction& candidate, std::size_t t, std::size_t s, Fit& fit) const {
  struct Block {
    explicit Block(bool freeBase) : before(freeBase), after(freeBase) {}
    Squares before, after;
    double doubt = 0, product = 0, change = 0;
  };
  const Trial& trial = data_.trials()[t];
  const std::vector<double>&weights = data_.weights(t, s), &predicted = candidate.values[s],
        &before = predictions_[t].values[s];
  const std::size_t first = data_.block(t, 0);
  std::vector<Block> blocks(data_.block(t, trial.cycles() - 1) - first + 1, Block(trial.freeBase));
  data_.forEach(t, s, predictions_[t], [&](std::size_t k, double known, double r) {
    // A replay that diverged counts as a large error, not as missing.
    const double d = std::isfinite(predicted[k]) ? predicted[k] - before[k] : 1e3;
    const double w = weights[k] * Evidence::certainty(candidate, s, k, weights[k]);
    Block& block = blocks[data_.block(t, k) - first];
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
  fit.squares = baseSquares_.squares;
  for (std::size_t t = 0; t < candidates.size(); ++t) {
    if (candidates[t].values.empty()) continue;
    const Trial& trial = data_.trials()[t];
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const auto& predicted = candidates[t].values[s];
      const auto& before = predictions_[t].values[s];
      if (predicted.empty() || before.empty()) continue;
      addChange(candidates[t], t, s, fit);
    }
  }
  for (std::size_t b = 0; b < fit.squares.size(); ++b)
    (Evidence::forFitting(b) ? fit.fitting : fit.judging) += fit.squares[b];
  return fit;
}

double Evaluator::chi(std::size_t trial, std::size_t signal) const { return chis_[trial][signal]; }

Fit Evaluator::with(const Cause& cause, const TrialMask& mask) const {
  std::vector<Prediction> candidates(data_.trials().size());
  for (std::size_t t = 0; t < candidates.size(); ++t) {
    if (leftOut(t) || (!mask.empty() && !mask[t])) continue;
    candidates[t] = changed(t, cause);
  }
  return compare(candidates);
}

std::vector<Prediction> Evaluator::played(const Explanation& explanation) const {
  const std::vector<int> joints = chainsThatDiffer(explanation);
  std::vector<Prediction> candidates(data_.trials().size());
  for (std::size_t t = 0; t < candidates.size() && !joints.empty(); ++t) {
    if (leftOut(t)) continue;
    const Trial& trial = data_.trials()[t];
    ReplayOptions options = optionsOf(t, explanation);
    if (!trial.freeBase) options.joints = joints;
    candidates[t] = predictEnsemble(plantOf(trial, explanation), trial, options);
  }
  return candidates;
}

}  // namespace plumbline::gap
