#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/Representation.h"

namespace plumbline {

/// A try of a motion that an optimiser asks for: a task of a search with its options, and the numbers to try.
REPRESENTATION(OptimizationTrial)
class OptimizationTrial : public OptimizationTrialBase {
public:
  bool open = false;                 ///< it is to be tried now
  std::int64_t number = -1;          ///< counts tries, of this agent
  std::uint64_t seed = 0;            ///< decides what is random in the try
  std::string task;                  ///< as a study names it
  std::vector<std::string> options;  ///< of the task: "KEY=VALUE" each (TaskOptions)
  std::vector<double> parameters;    ///< of the motion
  void stream(InStream* in, OutStream* out) override {
    STREAM(open);
    STREAM(number);
    STREAM(seed);
    STREAM(task);
    STREAM(options);
    STREAM(parameters);
  }
};

}  // namespace plumbline
