#pragma once
#include <vector>

#include "gap/diagnosis/GapMeter.h"

namespace plumbline::gap {

/// Least gain of the sum of squares on the blocks for judging that counts as one.
constexpr double leastGain = 30;

/// Sum of squares on the blocks for judging beyond what noise alone would leave.
double excess(const Evaluator& evaluator);

/// Squares over noise variance that the base leaves beyond noise, by direction of the data: engines, or a
/// robot and its model, differ in a few ways, two per channel and run as a rule, and which cause that favours
/// is chance.
double leftPerDirection(const Evaluator& evaluator);

/// Where an evaluator's base stands: what an added cause has to better.
class Standing {
public:
  explicit Standing(const Evaluator& evaluator);
  double judging() const { return fit.judging; }

  /// Whether the evaluator's present base earns the place of what was added to it: it lowers the worst
  /// channel or a good part of the whole, by no accident of a few blocks, and changes something visibly.
  /// leastPart: of the squares beyond noise, in all or in the worst channel where no cause is yet, that it
  /// has to explain.
  bool betteredBy(const Evaluator& evaluator, double leastPart = 0) const;

private:
  bool explainsWorst(const Evaluator& evaluator, double leastPart) const;

  Fit fit;
  std::vector<Prediction> predictions;
  WorstGap worst;
  bool worstHasCause;  ///< the worst channel is a joint's that has one
  double unexplained = 0;
};

}  // namespace plumbline::gap
