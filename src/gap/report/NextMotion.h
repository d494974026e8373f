#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/record/Excitation.h"

namespace plumbline::gap {

/// What a program would tell.
struct MotionScore {
  std::string name;
  /// Root mean square over a program's samples, in units of the sensors' noise and summed over the channels,
  /// of how one explanation's prediction differs from the nearest that another can come to it by another size
  /// of its effect. Of more than two explanations: the smallest of the pairs that count.
  double separation = 0;
};

struct NextMotion {
  Excitation program;
  MotionScore best;
  std::vector<MotionScore> others;  ///< the best first
};

struct NextMotionOptions {
  std::vector<int> joints;  ///< that the designed programs move; empty: those the explanations are about
  bool fromFirst = false;   ///< the first from each of the others counts, not every pair
  bool standing = false;    ///< standing programs of the library count as well
  std::function<void(double share)> progress = {};
};

/// The program with the greatest separation among designs for the joints in question and the library in
/// config/excitation, as predicted by replay. Throws std::invalid_argument for less than two explanations.
NextMotion findNextMotion(const Mechanism& robot, const std::vector<Explanation>& explanations,
                          NextMotionOptions options = {});

/// In a sentence: what to record so that the two come apart, and by how much.
std::string nextMotion(const Mechanism& robot, const Cause& a, const Cause& b);

/// Causes of other kinds at a joint, each of a size that shows; what a gap there could come from.
std::vector<Explanation> suspectsAt(const Mechanism& robot, int joint);

/// Joints whose motion shows an effect at a place.
std::vector<int> jointsShowing(const Mechanism& robot, const Place& place);

}  // namespace plumbline::gap
