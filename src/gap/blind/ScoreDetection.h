#pragma once
#include <optional>

#include "gap/blind/BlindScore.h"

namespace plumbline::gap {

/// One trial of a detector: how strong the effect was, and whether it was found.
struct Detection {
  double ratio = 0;  ///< gap over noise, above 0
  bool found = false;
};

/// Severity from which on a share is found, with its interval of 95 %. Outside of the severities tried
/// nothing is known: a value at or below the least one is that one with `below` set, one above the largest is
/// infinite (so is the interval's end).
struct DetectionLimit {
  double ratio = 0, lower = 0, upper = 0;
  bool below = false;
  std::size_t count = 0;  ///< cases it rests on; 0: there is no value
};

/// Logistic regression of `found` on the logarithm of the severity, with Firth's penalty, which stays finite
/// where all or none are found (Firth, Biometrika 80, 1993; Heinze and Schemper, Statistics in Medicine 21,
/// 2002), solved for the share. The interval is a bootstrap's over the cases. Where more is found of weak
/// ones than of strong ones, severity explains nothing: infinite, or `below`, by the share that is found.
DetectionLimit detectionLimit(const std::vector<Detection>& trials, double share = 0.9);

/// How an effect of the library fared over a set.
struct EffectScore {
  std::string effect;
  std::size_t singles = 0, found = 0;               ///< named first at its place, any severity
  std::size_t ofMixtures = 0, foundInMixtures = 0;  ///< named at its place, in any order
  /// Of singles: the least severity from which on every case was found; none where the strongest was missed.
  std::optional<double> allFoundFrom;
  std::optional<double> weakestFound, strongestMissed;
};

/// Per effect that occurs, in the library's order.
std::vector<EffectScore> effectScores(const BlindSet& set, const std::vector<BlindAnswer>& answers,
                                      const Mechanism& robot);

/// Singles as trials. seen: found is any verdict but `none`; else effect and place first.
std::vector<Detection> detectionsOf(const BlindSet& set, const std::vector<BlindAnswer>& answers,
                                    const Mechanism& robot, bool seen);

}  // namespace plumbline::gap
