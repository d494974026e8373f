#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/Representation.h"

namespace plumbline {

/// What the last try of an OptimizationTrial came to.
REPRESENTATION(OptimizationResult)
class OptimizationResult : public OptimizationResultBase {
public:
  std::int64_t number = -1;          ///< of the try; -1: none yet
  double cost = 0;                   ///< as the task has it
  std::vector<std::string> figures;  ///< their names
  std::vector<double> values;        ///< of the figures
  void stream(InStream* in, OutStream* out) override {
    STREAM(number);
    STREAM(cost);
    STREAM(figures);
    STREAM(values);
  }
};

}  // namespace plumbline
