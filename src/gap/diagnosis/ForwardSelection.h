#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "gap/diagnosis/Proposals.h"
#include "gap/diagnosis/Remainder.h"

namespace plumbline::gap {

/// Forward selection: starts at the fine evaluator's base and adds one cause at a time while each passes the
/// acceptance test (AcceptanceTest.h). Outside code that changes `causes` must also set the evaluator's base.
class ForwardSelection {
public:
  /// coarse: replays with longer steps, for screening.
  ForwardSelection(Evaluator& fine, Evaluator& coarse, const DiagnosisOptions& options)
      : fine_(fine), options_(options), proposals_(fine, coarse, options) {}

  /// Gap beyond noise of the worst channel, in units of its noise, below which no cause is searched.
  static constexpr double present = 0.9;

  Explanation causes;
  std::vector<std::vector<FittedCause>> choices;  ///< per cause: the alternatives, most probable first
  double worstBefore = 0;         ///< gap beyond noise of the worst channel without any cause [its noise]
  bool onFixedBaseRuns = false;   ///< these searches are not stored for a continued diagnosis
  bool lostCommandsLast = false;  ///< they are not searched

  /// Adds causes until none passes the test. most: sum of squares for judging above which a third cause is
  /// not added to two.
  void grow(double most = INFINITY);
  /// Adds command dropout if nothing remains with it.
  void addLostIfNothingRemains();
  /// What could be added to the base, most probable first.
  std::vector<FittedCause> candidates(const std::string& stage, bool onlySensors = false);
  /// Finds the alternatives to causes that were chosen together.
  void lookForRivals();
  Remainder remainder() const { return {fine_, worstBefore}; }
  void clear();

private:
  bool accept(const std::vector<FittedCause>& list);
  void setBaseTo(const Explanation& old, const Cause& cause);
  void settleLosses();
  bool decodeLossesWith(double strength);
  bool isOneServosSetting(const Cause& cause) const;
  double leastPart() const;
  std::vector<FittedCause> withItself(std::vector<FittedCause> list, const Cause& cause) const;

  Evaluator& fine_;
  const DiagnosisOptions& options_;
  Proposals proposals_;
};

}  // namespace plumbline::gap
