#pragma once
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"
#include "gap/blind/Planting.h"
#include "math/Random.h"

namespace plumbline::gap {

/// Recordings as they are, with what is needed to plant causes in them; shared by all cases.
struct PlantingBase {
  RealRecordings recordings;
  std::vector<double> nominal;               ///< residuals of the nominal model
  double gap = 0;                            ///< their root mean square [rad]
  std::vector<std::vector<double>> noise;    ///< per trial and signal
  std::vector<std::vector<Cause>> possible;  ///< plants of each kind, in the order of plantable()

  /// Throws std::runtime_error if nothing can be planted.
  explicit PlantingBase(RealRecordings recordings);
};

/// Plants causes for a case of this kind, fills in its effects and severity, and gives the recordings with
/// the changed model. `turn` chooses the kinds of causes in turn. Throws std::runtime_error if no plant fits.
RealRecordings plantCase(const PlantingBase& base, std::size_t turn, Random& random, BlindCase& c);

}  // namespace plumbline::gap
