#pragma once
#include <cstddef>
#include <vector>

#include "gap/inference/Density.h"

namespace plumbline::gap {

/// The most that causes can gain of what is left in a cell. Of what is at the noise in all, only single
/// values far beyond it can be gained.
struct MostOfCell {
  /// fit: of what is left.
  MostOfCell(const Split& left, const StretchFit& fit, double share);

  bool isAtNoise = false;  ///< in all
  double gain = 0;         ///< of log density
};

/// The most that causes can gain on top of a replayer's base: everything that is above the noise.
class MostToGain {
public:
  /// kinds: how many are possible; a cause has to gain the logarithm of that.
  MostToGain(const Replayer& replayer, const Shares& shares, std::size_t kinds);

  /// Flags of the trials that show whether a kind of cause is worth looking at; none where it has nothing to
  /// gain. A replay on the feet costs a hundred times one of a chain. So of recordings on the feet, a cause
  /// at a joint or at a link that joints move is first looked at in the one in which its chain is off most.
  std::vector<char> trialsFor(const Cause& cause) const;

private:
  bool isNear(const Cell& cell, const Cause& cause) const;

  const Replayer& replayer_;
  double price_;
  std::vector<double> most_;  ///< per cell
  std::vector<char> enough_;  ///< flags of trials
};

}  // namespace plumbline::gap
