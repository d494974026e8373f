#pragma once
#include <set>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// What a leg shows only with the robot's weight on it: where the held runs are clean and those on the feet
/// are not, a length, a mass, an offset or a weak motor of a leg is looked for in the latter. Of one base; a
/// third such cause is not looked for.
class UnderLoad {
public:
  explicit UnderLoad(const Evaluator& evaluator);
  /// Whether this effect at this place is looked for there.
  bool shows(const Effect& effect, const Place& place) const;

private:
  const Mechanism& robot_;
  std::vector<double> excess_;  ///< of the runs on the feet, see jointExcess(); empty: nothing to look for
  double worst_ = 0;
  std::set<int> legs_;  ///< joints
};

}  // namespace plumbline::gap
