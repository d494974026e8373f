#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/Representation.h"
#include "robot/JointId.h"

namespace plumbline {

/// A try of a kick that an optimiser asks for: its numbers (motion::SearchedKick) and how it is judged
/// (motion::KickWish).
REPRESENTATION(OptimizationTrial)
class OptimizationTrial : public OptimizationTrialBase {
public:
  bool open = false;         ///< it is to be tried now
  std::int64_t number = -1;  ///< counts tries, of this agent
  std::uint64_t seed = 0;    ///< decides the ball's place and the walk after the kick
  std::string motion;        ///< the kick that the search began with
  Side foot = Side::right;
  double spread = 0.01;                         ///< of the ball's place to each side [m]
  double distance = 0, weight = 0, steady = 0;  ///< of motion::KickWish
  std::vector<double> parameters;
  void stream(InStream* in, OutStream* out) override {
    STREAM(open);
    STREAM(number);
    STREAM(seed);
    STREAM(motion);
    STREAM(foot);
    STREAM(spread);
    STREAM(distance);
    STREAM(weight);
    STREAM(steady);
    STREAM(parameters);
  }
};

}  // namespace plumbline
