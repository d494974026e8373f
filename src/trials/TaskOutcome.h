#pragma once
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

/// What one run of a task gave: lower costs are better; the figures are for people.
struct TaskOutcome {
  double cost = 0;
  std::vector<std::pair<std::string, double>> figures{};
};

}  // namespace plumbline
