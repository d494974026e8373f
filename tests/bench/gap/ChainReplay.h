#pragma once
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::bench {

/// The joint that the nominal model misses most, and how well explanations fit there: its chain alone, with a
/// held base, on the two runs that tell most, in long steps. What the simpler ways fit on.
class ChainReplay {
public:
  /// nominal: an evaluator whose base is empty; it and its evidence must outlive this.
  ChainReplay(const gap::Evaluator& nominal, const gap::ReplayOptions& steps);

  /// Of the mechanism, the one with the motor; -1 where no run has a fixed base.
  int joint() const { return worst_; }
  /// Weighted squares of the residuals of the chain's positions and of the inertial sensors.
  struct Squares {
    double fitting = 0, judging = 0;
    double change = 0;  ///< of the prediction against the nominal one, on all blocks
  };
  Squares of(const gap::Explanation& causes) const;

private:
  void findJoint();
  void findRuns();
  gap::Prediction predict(std::size_t trial, const gap::Plant& plant) const;

  const gap::Evaluator& nominal_;
  const gap::Plant nominalPlant_;
  gap::ReplayOptions options_;
  int worst_ = -1;
  std::vector<std::size_t> runs_;
  std::vector<gap::Prediction> before_;  ///< per run: what the nominal model predicts
};

}  // namespace plumbline::bench
