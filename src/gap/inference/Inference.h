#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/diagnosis/Noise.h"
#include "gap/inference/HoldOut.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

struct InferenceOptions {
  int jobs = 1;
  std::size_t mostCauses = 8;
  std::function<void(const std::string& stage, double share)> progress = {};
};

/// What the method of doc/decisions/0007 says of some recordings.
struct Inference {
  Diagnosis diagnosis;  ///< its gap: positions of the recordings left out, pooled [rad, or m]
  /// What the values fitted to the other groups leave in each recording.
  std::vector<RecordingLeft> leftOut;
  bool stretchesOfOne = false;  ///< there was one recording: stretches of time were left out instead
  std::vector<std::vector<SignalNoise>> noises;  ///< per trial and signal
  /// Channels that were not used, with the reason: "vel.* is not used: ...".
  std::vector<std::string> notUsed;
  std::size_t replays = 0;

  double closed() const { return meanClosed(leftOut); }
  std::string sentence() const;  ///< the verdict for people
};

Inference infer(const Mechanism& robot, std::vector<Trial> trials, const InferenceOptions& options);

}  // namespace plumbline::gap
