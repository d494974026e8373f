#pragma once
#include <cstdint>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/inference/Groups.h"
#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// Commands that never came, in recordings with a fixed base. Which ones is decoded from each recording
/// (diagnosis/LostCycles.h) and holds for it alone; what holds for others as well is their share.
struct CommandLosses {
  std::vector<std::vector<std::uint8_t>> cycles;  ///< per trial; empty where not looked at
  std::vector<std::size_t> seen;                  ///< per trial: cycles in which a loss would have shown
  std::vector<std::size_t> found;                 ///< per trial: those of them that were lost
  /// Gain of log density over commands that all came, less the price of the cycles and of the cause.
  double evidence = 0;
  /// How many are found for each that was lost, and how many were found to learn that (measureRecovery).
  double recovered = 1;
  std::size_t foundInSimulation = 0;

  bool any() const { return share() > 0; }
  /// Of the commands in trials that are wanted (empty: in all): those found, divided by recovered.
  double share(const std::vector<char>& wanted = {}) const;
  /// Of the share, 95 %: wilsonInterval of as many as are found here and in the simulation, in series.
  Bounds interval() const;
  /// As a cause of a gap, of such a share.
  static Cause cause(double share);
};

/// Whether repeats with a fixed base differ by more than the readings' noise.
bool repeatsDiffer(const Groups& groups);

/// Whether recordings may have lost commands: none of those with a fixed base was repeated, or repeats differ
/// by more than the noise. What is lost by chance is another command each time.
bool mayHaveLostCommands(const Groups& groups);

/// What was lost if the robot has these causes; evidence 0. sent: trials as their commands were sent, of the
/// groups.
CommandLosses decodeLostCommands(const std::vector<Trial>& sent, const Groups& groups,
                                 const Explanation& causes, int jobs);

/// Sets recovered by a simulation: these recordings with other cycles lost, as large a share, and with the
/// readings' noise, are decoded in the same way. On a weak servo fewer losses are found than there are.
/// groups: of the trials that know what they lost.
void measureRecovery(CommandLosses& lost, const std::vector<Trial>& sent, const Groups& groups,
                     const Explanation& causes, int jobs);

/// Trials that know which commands they lost.
std::vector<Trial> withLost(std::vector<Trial> trials, const CommandLosses& lost);

/// What the robot with these causes reads in the trials with a fixed base; empty for others.
std::vector<Prediction> predictionsOf(const std::vector<Trial>& trials, const Explanation& causes, int jobs);

/// CommandLosses::evidence, of these causes and losses over the causes asSent with commands that all came.
/// known: of groups of trials that know what they lost. The price is minus the logarithm of the probability
/// of these cycles, whatever the share is, and of the causes among so many kinds.
double evidenceOf(const CommandLosses& lost, const Replayer& known, const Explanation& causes,
                  const Explanation& asSent, std::size_t kinds);

}  // namespace plumbline::gap
