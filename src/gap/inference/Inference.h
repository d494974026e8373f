#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/diagnosis/Noise.h"
#include "gap/inference/Claim.h"
#include "gap/inference/CommandLosses.h"
#include "gap/inference/HoldOut.h"
#include "gap/inference/Unexplained.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

class InferenceMemory;

struct InferenceOptions {
  int jobs = 1;
  std::size_t mostCauses = 0;         ///< in a set; 0: 8, or 12 of a robot with many kinds of causes
  InferenceMemory* memory = nullptr;  ///< of what a run that was stopped has done; null: none
  std::function<void(const std::string& stage, double share)> progress = {};
};

/// What the method of doc/decisions/0007 says of some recordings.
struct Inference {
  Diagnosis diagnosis;  ///< its gap: positions of the recordings left out, pooled [rad, or m]
  std::vector<Explanation> foundWithout;  ///< per group: the set that was searched for in the others alone
  /// What is left in each recording by that set, with its values in each joint if the answer has such.
  std::vector<RecordingLeft> leftOut;
  Claim claim;                  ///< of a recording that was not seen at all
  bool stretchesOfOne = false;  ///< there was one recording: stretches of time were left out instead
  std::vector<std::vector<SignalNoise>> noises;  ///< per trial and signal
  /// Channels that were not used, with the reason: "vel.* is not used: ...".
  std::vector<std::string> notUsed;
  /// Of causes that gain in one recording alone: "... is supported by RECORDING alone".
  std::vector<std::string> onlyIn;
  /// What repeats of a motion differ by beyond the readings' noise, over that noise, in the signal where it
  /// is largest.
  double repeatsDiffer = 0;
  std::string repeatsSignal;
  double bound = leastUnexplained;  ///< of Diagnosis::worstAfter: up to it nothing is unexplained
  /// Asked for, those that were in memory among them: of one chain of joints in one recording each.
  std::size_t replays = 0;
  CommandLosses lost;  ///< also one of the findings if there are any

  /// A remark where repeats differ by more than that noise; else empty. Without any cause the verdict is then
  /// unknown, not none.
  std::string runToRun() const;
  std::string sentence() const;  ///< the verdict for people
};

Inference infer(const Mechanism& robot, std::vector<Trial> trials, const InferenceOptions& options);

/// The one first without which the score of the causes loses most.
void sortByEvidence(std::vector<Finding>& findings);

}  // namespace plumbline::gap
