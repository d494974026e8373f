#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "gap/diagnosis/Evidence.h"
#include "gap/diagnosis/Explanation.h"

namespace plumbline::gap {

/// How well an explanation fits, per block, compared with the base explanation. Only the part that an added
/// cause can change is replayed; the rest is taken from the base.
struct Fit {
  /// Per block: squares of the residuals in units of noise variance. In runs on the feet the part beyond 25
  /// times the noise counts by its logarithm. For an uncertain prediction: twice the negative logarithm of
  /// its likelihood, relative to a prediction with only the channel's own noise.
  std::vector<double> squares;
  double fitting = 0, judging = 0;  ///< sums over blocks for fitting and for judging
  double product = 0, change = 0;   ///< over blocks for fitting: r * d and d * d, d = change against the base
  /// Share of the change that fits best (1: as it is); what the squares would then be.
  double bestShare() const { return change > 0 ? product / change : 0; }
};

/// Which trials are replayed, one flag each; empty: all.
using TrialMask = std::vector<std::uint8_t>;

class Evaluator {
public:
  /// accuracy: the steps of all replays; coarse ones are enough for screening.
  Evaluator(const Mechanism& mechanism, const Evidence& evidence, const ReplayOptions& accuracy = {});

  /// Sets the explanation to which candidates are added, and replays the part that it changes.
  void setBase(const Explanation& causes);
  const Explanation& base() const { return causes_; }
  const Fit& baseFit() const { return baseSquares_; }
  const Prediction& basePrediction(std::size_t trial) const { return predictions_[trial]; }

  /// Fit of base plus one cause; trials that are not replayed keep the base's squares. Thread-safe.
  Fit with(const Cause& cause, const TrialMask& mask = {}) const;
  /// Fit of another explanation. Thread-safe.
  Fit of(const Explanation& causes) const { return compare(played(causes)); }
  /// What another explanation predicts, one per trial: with a fixed base only the signals of the joints that
  /// differ from the base's, nothing where none do. Thread-safe.
  std::vector<Prediction> played(const Explanation& causes) const;
  /// Fit of predictions, each with the base's where it has none of its own. Thread-safe.
  Fit compare(const std::vector<Prediction>& candidates) const;

  /// Lost cycles found under the present base, used wherever dropout is a cause: one vector per trial. A base
  /// with dropout is replayed with them at once.
  void setLostCycles(std::vector<std::vector<std::uint8_t>> cycles);
  const std::vector<std::vector<std::uint8_t>>& lostCycles() const { return lost_; }

  /// Joints that a cause can move with a fixed base: its chain, all, or none.
  std::vector<int> jointsTouched(const Cause& cause) const;
  /// Excludes the runs on the feet, or includes them again. The base is nominal afterwards.
  void leaveFloatingBaseOut(bool out);
  bool hasFloatingBase() const { return floatingBaseRuns_ && !floatingBaseLeftOut_; }
  bool hasFixedBase() const { return fixedBaseRuns_; }
  /// Mean weighted square of the residuals of a signal in a trial under the base; 1 if only noise is left,
  /// NaN if nothing was compared. With a fixed base, the part that a lead or lag of 0.2 ms explains does not
  /// count.
  double chi(std::size_t trial, std::size_t signal) const;
  /// Calls use(trial, signal, chi) for every channel that was compared.
  template <class Use>
  void forEachChannel(Use&& use) const {
    for (std::size_t t = 0; t < chis_.size(); ++t)
      for (std::size_t s = 0; s < chis_[t].size(); ++s)
        if (std::isfinite(chis_[t][s])) use(data_.trials()[t], data_.trials()[t].signals[s], chis_[t][s]);
  }
  const Mechanism& mechanism() const { return robot_; }
  const Evidence& evidence() const { return data_; }
  const ReplayOptions& replayOptions() const { return accuracy_; }

private:
  bool leftOut(std::size_t trial) const { return floatingBaseLeftOut_ && data_.trials()[trial].freeBase; }
  ReplayOptions optionsOf(std::size_t trial, const Explanation& explanation) const;
  void replayBase(const Explanation& explanation);
  /// Joints to replay with a fixed base if another explanation replaces the base.
  std::vector<int> chainsThatDiffer(const Explanation& other) const;
  Prediction changed(std::size_t trial, const Cause& cause) const;
  /// Adds what a candidate changes in one signal.
  void addChange(const Prediction& candidate, std::size_t trial, std::size_t signal, Fit& fit) const;

  const Mechanism& robot_;
  const Evidence& data_;
  ReplayOptions accuracy_;
  Explanation causes_;
  std::vector<Plant> basePlants_;  ///< per trial
  std::vector<Prediction> predictions_;
  std::vector<std::vector<double>> chis_;
  Fit baseSquares_;
  std::vector<std::vector<std::uint8_t>> lost_;
  bool floatingBaseRuns_ = false, fixedBaseRuns_ = false, floatingBaseLeftOut_ = false;
};

}  // namespace plumbline::gap
