#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "simspark/LeagueTrace.h"

namespace plumbline::simulation {

/// Target of a figure of a trace: within `absolute`, or within `relative` of the league's value.
struct FidelityTarget {
  std::optional<double> absolute, relative;
};

/// One line of the table of fidelity: a figure of one trace, the league's and ours.
struct FidelityLine {
  std::string trace, figure, unit;
  std::optional<double> league, ours;  ///< absent for deviations row by row
  double difference = 0;               ///< ours - league's, or the deviation
  std::optional<double> spread;        ///< how far the server is from itself in this figure
  FidelityTarget target;

  /// Largest difference that meets the target; absent where nothing is asked for.
  std::optional<double> allowed() const;
  bool met() const;
};

/// Difference of the league's server from itself, by figure, when the same commands are sent again.
using LeagueSpread = std::map<std::string, double>;

/// All lines of one trace; which, goes by its name (stand, crouch, swing, fallF, fallB, ut_walk, ut_turn,
/// ut_getup, ut_kick, ballfoot, ball_roll, ball_bounce, ball_lob). A figure of walking or turning is asked
/// to be within 2 % only where the server is so near to itself.
std::vector<FidelityLine> fidelityLines(const simspark::LeagueTrace& trace,
                                        const std::vector<simspark::TraceRow>& ours,
                                        const LeagueSpread& spread);

/// What a trace and its repetition on the league's server differ by, in all lines. Error:
/// std::invalid_argument if they differ in length.
LeagueSpread leagueSpread(const simspark::LeagueTrace& trace, const simspark::LeagueTrace& again);

}  // namespace plumbline::simulation
