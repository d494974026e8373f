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

/// What of an answer counts.
struct BlindAnswer {
  std::string name;     ///< of the case
  std::string verdict;  ///< none, effect, unknown; empty: there is no answer
  struct Named : NamedCause {
    std::vector<NamedCause> rivals;
  };
  std::vector<Named> effects;  ///< strongest first
  std::optional<double> closed;
};

/// Reads FOLDER/<case>.json for each case; one that is missing gets an empty verdict, which scores as wrong.
/// Throws ConfigurationError for a file that is no answer, and where there is none at all.
std::vector<BlindAnswer> readAnswers(const BlindSet& set, const std::string& folder);

/// A figure with its interval of 95 %.
struct Figure {
  std::string id, what;
  double value = 0, lower = 0, upper = 0;
  std::size_t count = 0;  ///< cases, or answers, that it rests on; 0: there is no value
};

struct BlindScore {
  /// On cases whose ratio is leastRatio or more, and on those without an effect.
  std::vector<Figure> figures;
  /// Effect and place first, of singles, by severity: all cases, from below leastRatio up.
  std::vector<Figure> bySeverity;
  std::size_t cases = 0, missing = 0;

  const Figure& figure(std::string_view id) const;
};

/// Scores answers, in the set's order. An effect counts as found at the same place, axis included; two
/// joints of one motor count as one place. A verdict other than `effect` names nothing.
BlindScore scoreBlind(const BlindSet& set, const std::vector<BlindAnswer>& answers, const Mechanism& robot);

std::string scoreTable(const BlindScore& score);
std::string scoreJson(const BlindScore& score);

/// Wilson's interval of a share, 95 % (Wilson, JASA 22, 1927).
Figure share(std::string id, std::string what, std::size_t hits, std::size_t count);

/// Expected calibration error: over ten bins of probability, the mean distance of how often answers were
/// right from the mean probability given, weighted by the answers in the bin (Naeini et al., AAAI 2015).
struct Graded {
  double probability = 0;
  bool right = false;
};
double calibrationError(const std::vector<Graded>& graded);

}  // namespace plumbline::gap
