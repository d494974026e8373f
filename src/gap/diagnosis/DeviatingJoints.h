#pragma once
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// The worst mean square beyond noise of each joint's positions under the base, in runs with a floating
/// base or with a fixed one. In units of noise variance, one per joint; 0 where nothing was compared.
std::vector<double> jointExcess(const Evaluator& evaluator, bool floatingBase);

/// Joints that deviate in recordings with a fixed base: by themselves (or because repeats differ), or in a
/// chain of which a joint deviates. Without such recordings: all of them.
struct DeviatingJoints {
  explicit DeviatingJoints(const Evaluator& evaluator);
  std::vector<bool> joint, chain;  ///< one flag per joint
  std::vector<bool> weak;          ///< by themselves, however much more the joints deviate that carry them
  bool any = false;

private:
  void onlyDeviating(const Evaluator& evaluator);
};

/// Whether most of the robot deviates, as after lost commands: most chains, or most joints of a robot with
/// few chains.
bool mostDeviates(const Evaluator& evaluator);

}  // namespace plumbline::gap
