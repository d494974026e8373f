#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>

#include "training/Study.h"

namespace plumbline {

/// Mean and standard error of cost and figures over this number of seeds that no search uses, from the given
/// one on, on all cores. Returns the means, and of each figure the deviation as SearchTask::file wants it.
/// Prints a line that begins with `what`.
std::map<std::string, double> measure(const training::Study& study, const std::string& what,
                                      const Eigen::VectorXd& values, int runs, std::uint64_t first);

}  // namespace plumbline
