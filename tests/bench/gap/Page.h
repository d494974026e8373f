#pragma once
#include <string>
#include <vector>

#include "gap/blind/BlindScore.h"

namespace plumbline::bench {

/// What a figure has to reach.
struct Target {
  const char* id;
  double value;
  bool higher;
};
/// Null where a figure has none.
const Target* targetOf(const std::string& id);

/// One way to answer, and how it did on the cases that it was asked.
struct Way {
  std::string id, what;
  gap::BlindScore score;
  bool placeOnly = false;
};

/// CPU time of the diagnoses that were timed [s].
struct Timing {
  std::size_t count = 0;
  double mean = 0, p95 = 0, most = 0;
};
Timing timingOf(std::vector<double> seconds);

struct BenchResult {
  gap::BlindSet set;
  Mechanism robot;
  std::vector<gap::BlindAnswer> answers;  ///< of the diagnosis, in the set's order
  gap::BlindScore own;                    ///< the diagnosis on all cases
  /// The diagnosis first, on the cases that the simpler ways were asked, then those.
  std::vector<Way> ways;
  Timing timing;
};

/// The page doc/results/gap.md, its title aside.
std::string pageBody(const BenchResult& result);

// Its parts.
std::string effectsSection(const BenchResult& result);      ///< where each effect is first found
std::string calibrationSection(const BenchResult& result);  ///< what stated probabilities are worth
std::string casesSection(const BenchResult& result);        ///< what went wrong, then every case

std::string number(double x);
/// "0.950 [0.910, 0.980]", or "-" where there is no case.
std::string cell(const gap::Figure& figure);
/// "| a | b |" with a line end.
std::string row(const std::vector<std::string>& cells);
/// A table's head with its rule.
std::string head(const std::vector<std::string>& cells);

}  // namespace plumbline::bench
