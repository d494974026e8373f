#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/record/Excitation.h"

namespace plumbline::gap {

/// How well a program separates explanations.
struct MotionScore {
  std::string name;
  /// Difference between the predictions of two explanations: root mean square over a program's samples, in
  /// units of the sensors' noise, summed over the channels. One of the two gets the size of its effect that
  /// comes closest to the other. For more than two explanations: the smallest value of the pairs that count.
  double separation = 0;
};

struct NextMotion {
  Excitation program;
  MotionScore best;
  std::vector<MotionScore> others;  ///< the best first
};

struct NextMotionOptions {
  std::vector<int> joints;    ///< that the designed programs move; empty: those of the explanations
  bool fromFirst = false;     ///< only pairs with the first explanation count, not every pair
  bool floatingBase = false;  ///< also programs of config/excitation/ for a floating base
  std::function<void(double share)> progress = {};
};

/// The program with the greatest separation among designs for the joints in question and the library in
/// config/excitation, as predicted by replay. Throws std::invalid_argument for less than two explanations.
NextMotion findNextMotion(const Mechanism& robot, const std::vector<Explanation>& explanations,
                          NextMotionOptions options = {});

/// In a sentence: what to record to separate the two, and by how much.
std::string nextMotion(const Mechanism& robot, const Cause& a, const Cause& b);

/// Possible causes of a gap at a joint, each with a visible size.
std::vector<Explanation> suspectsAt(const Mechanism& robot, int joint);

/// Joints whose motion shows an effect at a place.
std::vector<int> jointsShowing(const Mechanism& robot, const Place& place);

}  // namespace plumbline::gap
