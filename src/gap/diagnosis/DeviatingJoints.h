#pragma once
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// The worst mean square beyond noise of each joint's positions under the base, in runs on the feet
/// (standing) or with a held base. In units of noise variance, one per joint; 0 where nothing was compared.
std::vector<double> jointExcess(const Evaluator& evaluator, bool standing);

/// Joints that runs with a held base show to be off: themselves (or by repeats that go apart), and in a chain
/// of which any is. All of them where there are no such runs.
struct Suspects {
  explicit Suspects(const Evaluator& evaluator);
  std::vector<bool> joint, chain;  ///< one flag per joint
  std::vector<bool> faintly;       ///< themselves, however much more the joints are that carry them
  bool any = false;

private:
  void onlyWhatIsOff(const Evaluator& evaluator);
};

/// Whether most of the robot is off, as lost commands would leave it: its chains, or the joints of a robot
/// that has few chains.
bool mostIsOff(const Evaluator& evaluator);

}  // namespace plumbline::gap
