#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/blind/BlindCase.h"

namespace plumbline::gap {

/// A cause that an answer names.
struct NamedCause {
  std::string effect, at, axis;
  double value = 0, probability = 0;
};

/// The scored part of an answer.
struct BlindAnswer {
  std::string name;     ///< of the case
  std::string verdict;  ///< none, effect, unknown; empty: there is no answer
  struct Named : NamedCause {
    std::vector<NamedCause> rivals;
  };
  std::vector<Named> effects;  ///< strongest first
  std::optional<double> closed;
};

/// Reads FOLDER/<case>.json for each case; a missing one gets an empty verdict, which counts as wrong. Throws
/// ConfigurationError for a file that is no answer, and if there is no answer at all.
std::vector<BlindAnswer> readAnswers(const BlindSet& set, const std::string& folder);

/// A figure with its interval of 95 %.
struct Figure {
  std::string id, what;
  double value = 0, lower = 0, upper = 0;
  std::size_t count = 0;  ///< cases, or answers, that it rests on; 0: there is no value
};

/// Answers whose probability lies in a range: their mean probability, and how many of them are right.
struct CalibrationBin {
  double from = 0, to = 0;
  double stated = 0;  ///< mean of the probabilities given
  Figure right;
};

struct BlindScore {
  /// On cases whose ratio is leastRatio or more, and on those without an effect.
  std::vector<Figure> figures;
  /// Effect and place first, of singles, by severity: all cases, from below leastRatio up.
  std::vector<Figure> bySeverity;
  std::vector<CalibrationBin> calibration;  ///< ten, of the effects named
  std::size_t cases = 0, missing = 0;

  const Figure& figure(std::string_view id) const;
};

/// Scores answers, in the set's order, each by BlindJudge. A missing answer is wrong. `unknown` is wrong if
/// the library has the effect, even if its nearest explanation is right; every other verdict is wrong if it
/// has not. Only effects named under the verdict `effect` count for calibration.
BlindScore scoreBlind(const BlindSet& set, const std::vector<BlindAnswer>& answers, const Mechanism& robot);

std::string scoreTable(const BlindScore& score);
std::string scoreJson(const BlindScore& score);

/// A share with its wilsonInterval.
Figure share(std::string id, std::string what, std::size_t hits, std::size_t count);

/// Calibration in ten bins of probability. Expected calibration error: over the bins, the mean distance of
/// how often answers were right from the mean probability given, weighted by the answers in the bin (Naeini
/// et al., AAAI 2015).
struct Graded {
  double probability = 0;
  bool right = false;
};
std::vector<CalibrationBin> calibrationBins(const std::vector<Graded>& graded);
double calibrationError(const std::vector<Graded>& graded);

}  // namespace plumbline::gap
