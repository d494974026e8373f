#include "Measuring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "framework/Parallel.h"
#include "framework/StopSignal.h"

namespace plumbline {
namespace {

/// Half the distance from the 16th to the 84th percentile: the standard deviation of normal values, which a
/// few failed tries hardly change.
double deviation(std::vector<double> values) {
  const auto at = [&](double share) {
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  return (at(0.84) - at(0.16)) / 2;
}

}  // namespace

std::map<std::string, double> measure(const training::Study& study, const std::string& what,
                                      const Eigen::VectorXd& values, int runs, std::uint64_t first) {
  const std::uint64_t fresh = (std::uint64_t{1} << 40) + first;  // beyond the 32 bits of a search's seeds
  std::vector<TaskOutcome> outcomes(static_cast<std::size_t>(runs));
  const std::size_t jobs = static_cast<std::size_t>(std::min(threadsFor(0), runs));
  parallel(jobs, static_cast<int>(jobs), [&](std::size_t job) {
    const auto task = training::makeTask(study.task, study.options);
    for (std::size_t i = job; i < outcomes.size(); i += jobs) {
      StopSignal::throwIfCaught();
      outcomes[i] = task->run(values, fresh + i);
    }
  });
  std::map<std::string, std::pair<double, double>> sums;
  for (const TaskOutcome& outcome : outcomes) {
    const auto add = [&](const std::string& name, double value) {
      sums[name].first += value / runs;
      sums[name].second += value * value / runs;
    };
    add("cost", outcome.cost);
    for (const auto& [name, value] : outcome.figures) add(name, value);
  }
  fmt::print("{:<8}", what);
  for (const auto& [name, sum] : sums)
    fmt::print("  {} {:.5g} +- {:.2g}", name, sum.first,
               std::sqrt(std::max(0.0, sum.second - sum.first * sum.first) / runs));
  fmt::print("\n");
  std::fflush(stdout);
  std::map<std::string, double> means;
  std::map<std::string, std::vector<double>> all;
  for (const TaskOutcome& outcome : outcomes)
    for (const auto& [name, value] : outcome.figures) all[name].push_back(value);
  for (const auto& [name, sum] : sums) means[name] = sum.first;
  for (const auto& [name, values] : all) means[name + training::deviationSuffix] = deviation(values);
  return means;
}

}  // namespace plumbline
