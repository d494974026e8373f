#pragma once
#include <functional>
#include <string>

namespace plumbline {

/// What a platform's robots are called by the number that searches have for them (their option `type`). An
/// agent's modules get it from a platform whose robots have numbers.
struct RobotTypes {
  std::function<std::string(int)> nameOf;  ///< as in RobotDescription
};

}  // namespace plumbline
