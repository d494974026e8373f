#pragma once
#include <vector>

#include "gap/diagnosis/GapMeter.h"

namespace plumbline::gap {

/// Least gain of the sum of squares on the blocks for judging that counts as one.
constexpr double leastGain = 30;

/// Sum of squares on the blocks for judging beyond what noise alone would leave.
double excess(const Evaluator& evaluator);

/// Squares over noise variance that the base leaves beyond noise, per direction of the data. Engines, or a
/// robot and its model, differ in a few ways, usually two per channel and run. Which cause these differences
/// favour is chance.
double leftPerDirection(const Evaluator& evaluator);

/// Decides whether a further cause is accepted, against the fit of the evaluator's base before it was added.
class AcceptanceTest {
public:
  explicit AcceptanceTest(const Evaluator& evaluator);
  double judging() const { return fit_.judging; }

  /// Whether the evaluator's present base passes. It must improve the worst channel or a good part of the
  /// whole, on more than a few blocks, and must change a prediction by more than the noise. leastPart: share
  /// of the squares beyond noise that it must explain, in all channels or in the worst channel that has no
  /// cause yet.
  bool passes(const Evaluator& evaluator, double leastPart = 0) const;

private:
  bool explainsWorst(const Evaluator& evaluator, double leastPart) const;

  Fit fit_;
  std::vector<Prediction> predictions_;
  WorstGap worst_;
  bool worstHasCause_;  ///< the worst channel is a joint's that has one
  double unexplained_ = 0;
};

}  // namespace plumbline::gap
