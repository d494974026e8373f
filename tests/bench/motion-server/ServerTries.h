#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "training/ServerTrial.h"

namespace plumbline::bench {

/// Each try of one motion, in the order of the tries.
struct StandUpTries {
  std::vector<bool> up;              ///< leans by less than 30 degrees after two seconds of walking
  std::vector<double> milliseconds;  ///< of the motion
};
struct KickTries {
  std::vector<bool> up;
  std::vector<double> distance, direction, height;  ///< along [m], left of forward [deg], of the centre [m]
};

/// Called after each try.
using Progress = std::function<void()>;

/// Falls forward or backward, plays the motion and walks on (Seekircher 2015, 3.1.1). direction: 1 forward,
/// -1 backward.
StandUpTries tryStandUp(training::ServerTrial& trial, const std::string& motion, int direction, int tries,
                        std::uint64_t firstSeed, const Progress& progress);
/// Comes to rest before a ball that lies within 1 cm of where the kick wants it, kicks, and walks on.
KickTries tryKick(training::ServerTrial& trial, const std::string& motion, int tries, std::uint64_t firstSeed,
                  const Progress& progress);

}  // namespace plumbline::bench
