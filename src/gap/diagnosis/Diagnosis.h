#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gap/diagnosis/SearchMemory.h"

namespace plumbline::gap {

enum class Verdict { none, effect, unknown };
const char* nameOf(Verdict verdict);  ///< as in the contract

/// Another cause that would explain nearly as well.
struct Rival {
  Cause cause;
  double probability = 0;
};

/// A cause found, with its probability.
struct Finding {
  Cause cause;
  double lower = 0, upper = 0;  ///< interval of the value, 95 %
  double probability = 0;
  double closedAlone = 0, closedLast = 0;  ///< share of the gap: with this one only; by adding it last
  std::vector<Rival> rivals;
  /// Of method sets: what the score of the set loses without this cause [nat].
  std::optional<double> evidence = {};
};

/// Root mean squares on blocks that were not used for the fit, in units of each signal's own noise.
struct GapSize {
  double before = 0, after = 0, floor = 1;
  double closed() const { return before > floor ? (before - after) / (before - floor) : 1; }
};

struct DiagnosisOptions {
  int jobs = 1;
  std::size_t maxCauses = 3;
  SearchMemory* memory = nullptr;  ///< of searches done before; null: none
  std::function<void(const std::string& stage, double share)> progress = {};
};

/// What is missing from the nominal model.
struct Diagnosis {
  Verdict verdict = Verdict::none;
  std::vector<Finding> findings;
  GapSize gap;
  double worstBefore = 0,
         worstAfter = 0;  ///< gap beyond noise, in units of noise, in the channel and run that show most
  std::string worstSignal, worstSignalAfter;
  /// Sensor at rest whose mean reading is off by more than any cause explains, and by how many times its
  /// noise; empty: none.
  std::string sensorOff;
  double sensorOffBy = 0;
  double left = 0;              ///< squares beyond noise; see leftPerDirection()
  double knownProbability = 1;  ///< that the library's effects account for the data
  /// Where kinds of causes differ from joint to joint: the causes found with their values in each joint.
  Explanation jointValues;
  Explanation explanation() const;  ///< the causes found
  /// What the gap is closed with: the values in each joint if there are any, else the causes found.
  Explanation replayed() const { return jointValues.empty() ? explanation() : jointValues; }
};

/// Adds causes one at a time while each improves data to which it was not fitted, then fits each again
/// together with the others. The verdict is none, effect or unknown.
Diagnosis diagnose(Evaluator& fine, Evaluator& coarse, const DiagnosisOptions& options);

}  // namespace plumbline::gap
