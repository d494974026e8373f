#pragma once
#include <cstdint>

#include "framework/Representation.h"

namespace plumbline {

/// What the last try of an OptimizationTrial came to.
REPRESENTATION(OptimizationResult)
class OptimizationResult : public OptimizationResultBase {
public:
  std::int64_t number = -1;  ///< of the try; -1: none yet
  double cost = 0;           ///< motion::KickWish
  double distance = 0;       ///< of the ball along the wanted direction [m]
  double direction = 0;      ///< [degrees]
  double time = 0;           ///< of the motion [ms]
  double error = 0;          ///< motion::KickTry
  bool up = false;           ///< leans by less than 30 degrees after the walk
  void stream(InStream* in, OutStream* out) override {
    STREAM(number);
    STREAM(cost);
    STREAM(distance);
    STREAM(direction);
    STREAM(time);
    STREAM(error);
    STREAM(up);
  }
};

}  // namespace plumbline
