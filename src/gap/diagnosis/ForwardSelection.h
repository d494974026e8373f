#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "gap/diagnosis/Proposals.h"
#include "gap/diagnosis/Remainder.h"

namespace plumbline::gap {

/// Forward selection: starts at the fine evaluator's base and adds one cause at a time while each passes the
/// acceptance test (Merit.h). Whoever changes `causes` from outside sets the evaluator's base too.
class ForwardSelection {
public:
  /// coarse: replays with longer steps, for screening.
  ForwardSelection(Evaluator& fine, Evaluator& coarse, const DiagnosisOptions& options)
      : fine_(fine), options_(options), proposals_(fine, coarse, options) {}

  /// Gap beyond noise of the worst channel, in units of its noise, below which nothing is looked for.
  static constexpr double present = 0.9;

  Explanation causes;
  std::vector<std::vector<Candidate>> choices;  ///< per cause: what stood for choice, most probable first
  double worstBefore = 0;         ///< gap beyond noise of the worst channel without any cause [its noise]
  bool onFixedBaseRuns = false;   ///< these searches are not kept for a diagnosis that goes on
  bool lostCommandsLast = false;  ///< they are not looked for

  /// Adds causes until none earns its place. most: sum of squares for judging above which two causes are not
  /// worth a third.
  void grow(double most = INFINITY);
  /// Command dropout comes in where nothing remains then.
  void addLostIfNothingRemains();
  /// What could be added to the base, most probable first.
  std::vector<Candidate> candidates(const std::string& stage, bool onlySensors = false);
  /// What stood for choice besides causes that were chosen together.
  void lookForRivals();
  Remainder remainder() const { return {fine_, worstBefore}; }
  void clear();

private:
  bool accept(const std::vector<Candidate>& list);
  void setBaseTo(const Explanation& old, const Cause& cause);
  void settleLosses();
  bool decodeBeside(double strength);
  bool isOneServosSetting(const Cause& cause) const;
  double leastPart() const;
  std::vector<Candidate> withItself(std::vector<Candidate> list, const Cause& cause) const;

  Evaluator& fine_;
  const DiagnosisOptions& options_;
  Proposals proposals_;
};

}  // namespace plumbline::gap
