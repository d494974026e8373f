#pragma once
#include <optional>

#include "gap/blind/BlindScore.h"

namespace plumbline::gap {

/// One trial of a detector: how strong the effect was, and whether it was found.
struct Detection {
  double ratio = 0;  ///< gap over noise, above 0
  bool found = false;
};

/// Severity from which on a share is found, with its interval of 95 %. Nothing is known outside of the
/// severities tried. A value at or below the smallest one is the smallest one, with `below` set; a value
/// above the largest is infinite, and so is the interval's end.
struct DetectionLimit {
  double ratio = 0, lower = 0, upper = 0;
  bool below = false;
  std::size_t count = 0;  ///< cases it rests on; 0: there is no value
};

/// Logistic regression of `found` on the logarithm of the severity, solved for the share. Firth's penalty
/// keeps it finite if all or none are found (Firth, Biometrika 80, 1993; Heinze and Schemper, Statistics in
/// Medicine 21, 2002). The interval is a bootstrap over the cases. If weak effects are found more often than
/// strong ones, severity explains nothing: the result is infinite, or `below`, depending on the share found.
DetectionLimit detectionLimit(const std::vector<Detection>& trials, double share = 0.9);

/// How often an effect of the library was found in a set.
struct EffectScore {
  std::string effect;
  std::size_t singles = 0, found = 0;               ///< named first at its place, any severity
  std::size_t ofMixtures = 0, foundInMixtures = 0;  ///< named at its place, in any order
  /// For singles: the smallest severity from which on every case was found; none if the strongest was missed.
  std::optional<double> allFoundFrom;
  std::optional<double> weakestFound, strongestMissed;
};

/// Per effect that occurs, in the library's order.
std::vector<EffectScore> effectScores(const BlindSet& set, const std::vector<BlindAnswer>& answers,
                                      const Mechanism& robot);

/// Singles as trials. seen: `found` means any verdict except `none`; otherwise effect and place first.
std::vector<Detection> detectionsOf(const BlindSet& set, const std::vector<BlindAnswer>& answers,
                                    const Mechanism& robot, bool seen);

}  // namespace plumbline::gap
