#pragma once
#include "gap/inference/CoefficientReplayer.h"
#include "gap/inference/Density.h"

namespace plumbline::gap {

/// Residuals of free replays as the one score sees them (doc/decisions/0007): of each channel in each trial a
/// cell for its mean and one for what varies about it, both over the noise. Of long ones, every n-th sample;
/// of many trials, enough (enoughTrials).
class FreeCoefficients : public CoefficientReplayer {
public:
  /// replayer must outlive it.
  explicit FreeCoefficients(const Replayer& replayer);

  Coefficients coefficients(const Explanation& causes) const override;
  const std::vector<CoefficientCell>& cells() const override { return cells_; }
  const Groups& groups() const override { return replayer_.groups(); }
  const Mechanism& mechanism() const override { return replayer_.mechanism(); }
  std::vector<CauseKind> kinds() const override;
  bool updateColumnShares(const Explanation& causes) override;

private:
  const Replayer& replayer_;
  const std::vector<char> looked_;      ///< per trial
  std::vector<CoefficientCell> cells_;  ///< two for each of sources_: mean, and what varies
  std::vector<std::size_t> sources_;    ///< places in groups().cells()
};

}  // namespace plumbline::gap
