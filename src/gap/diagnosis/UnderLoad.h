#pragma once
#include <set>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Causes that a leg shows only under the robot's weight. If runs with a fixed base have no gap and those on
/// the feet have one, a length, a mass, an offset or a weak motor of a leg is searched in the latter. Belongs
/// to one base; a third such cause is not searched.
class UnderLoad {
public:
  explicit UnderLoad(const Evaluator& evaluator);
  /// Whether this effect at this place is searched.
  bool shows(const Effect& effect, const Place& place) const;

private:
  const Mechanism& robot_;
  std::vector<double> excess_;  ///< of the runs on the feet, see jointExcess(); empty: nothing to search
  double worst_ = 0;
  std::set<int> legs_;  ///< joints
};

}  // namespace plumbline::gap
