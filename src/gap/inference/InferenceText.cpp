#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gap/inference/Inference.h"

namespace plumbline::gap {

namespace {

std::string howRepeatsDiffer(const Inference& of) {
  char text[128];
  std::snprintf(text, sizeof text, "differ by %.1f times the readings' noise in ", of.repeatsDiffer);
  return text + of.repeatsSignal;
}

}  // namespace

std::string Inference::runToRun() const {
  if (repeatsDiffer <= leastUnexplained) return "";
  return "Something changes from run to run: repeats of one motion " + howRepeatsDiffer(*this) +
         (lost.any() ? ". Lost commands explain a part of it"
                     : ". No lost commands were found that explain it") +
         "; what is missing within that is not seen.";
}

std::string Inference::sentence() const {
  if (diagnosis.verdict == Verdict::unknown && diagnosis.worstAfter <= bound)
    return "The nominal model explains these runs only as far as repeats of one motion agree, and those " +
           howRepeatsDiffer(*this) + ".";
  char text[256];
  if (diagnosis.verdict == Verdict::none) {
    std::snprintf(text, sizeof text,
                  "The nominal model explains these runs down to their noise (worst channel %.1f times the "
                  "noise beyond it).",
                  diagnosis.worstBefore);
    return text;
  }
  std::string causes;
  for (const Finding& finding : diagnosis.findings) {
    std::snprintf(text, sizeof text, " (%.0f %%)", 100 * finding.probability);
    causes += (causes.empty() ? "" : ", ") + describe(finding.cause) + text;
  }
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const RecordingLeft& left : leftOut) {
    if (!left.showsGap()) continue;
    least = std::min(least, left.closedToNoise());
    most = std::max(most, left.closedToNoise());
  }
  std::snprintf(
      text, sizeof text,
      "Of another recording's gap it is expected to close %.0f %% (90 %%: %.0f to %.0f %%); of %s it "
      "closed %.0f to %.0f %%.",
      100 * claim.closed, 100 * claim.lower, 100 * claim.upper,
      stretchesOfOne ? "stretches of the one recording, each left out in turn,"
                     : "these, each left out of search and fit in turn,",
      100 * least, 100 * most);
  const std::string claimed =
      least <= most
          ? text + std::string(lost.any()
                                   ? " No model knows which commands will be lost, so what that changes "
                                     "in a recording stays open."
                                   : "")
          : "In none of the recordings are all joints together off by more than the noise, so it is not "
            "known how far another recording's gap closes.";
  if (diagnosis.verdict == Verdict::effect)
    return "Missing from the model: " + causes + "; what is left is within " +
           (bound > leastUnexplained ? "what engines differ by on the feet. " : "the noise. ") + claimed;
  std::snprintf(text, sizeof text,
                "More is missing than the library's effects account for: %.1f times the noise remain in %s.",
                diagnosis.worstAfter, diagnosis.worstSignalAfter.c_str());
  if (causes.empty()) return text;
  return text + (" The nearest explanation is " + causes + ". ") + claimed;
}

}  // namespace plumbline::gap
