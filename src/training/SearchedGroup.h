#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "framework/ModuleParameters.h"
#include "parameters/Parameter.h"
#include "training/GroupedLines.h"
#include "training/SearchTask.h"

namespace plumbline::training {

/// A number of a parameter group that a task searches, by its path, and the standard deviation of the first
/// candidates, in the parameter's unit.
struct SearchedPath {
  const char* path;
  double sigma;
};

/// A parameter group of which a task searches some numbers, begun with a map of a configuration file. A run
/// has what the file would have: numbers of four digits. `among`: only those for which it holds are searched;
/// the others keep their values, and are written with them.
template <typename Group>
class SearchedGroup {
public:
  SearchedGroup(const ConfigSection& section, std::span<const SearchedPath> numbers,
                const std::function<bool(const std::string& path)>& among = {}) {
    readParameters(section, Group::parameterList(), &first_);
    Group::parameterList().visit(
        &first_, [&](const std::string& path, const Parameter& parameter, const ParameterPointer& value) {
          const auto one = std::ranges::find(numbers, path, &SearchedPath::path);
          if (one == numbers.end()) return;
          written_.push_back(path);
          if (among && !among(path)) return;
          paths_.push_back(path);
          parameters_.push_back({nameOf(path), *std::get<double*>(value), parameter.range.min,
                                 parameter.range.max, one->sigma});
        });
  }

  const std::vector<TaskParameter>& parameters() const { return parameters_; }
  const Group& first() const { return first_; }  ///< as the configuration file has it

  /// The group with these values, in the order of parameters().
  Group with(const Eigen::VectorXd& values) const {
    Group result = first_;
    Group::parameterList().visit(
        &result, [&](const std::string& path, const Parameter&, const ParameterPointer& value) {
          const auto found = std::ranges::find(paths_, path);
          if (found != paths_.end()) *std::get<double*>(value) = rounded(values[found - paths_.begin()]);
        });
    return result;
  }

  /// The values as lines within a map of a YAML file.
  GroupedLines lines(const Eigen::VectorXd& values) const {
    GroupedLines lines("  ", digits);
    Group group = with(values);
    Group::parameterList().visit(
        &group, [&](const std::string& path, const Parameter&, const ParameterPointer& value) {
          if (std::ranges::find(written_, path) != written_.end()) lines.add(path, *std::get<double*>(value));
        });
    return lines;
  }

private:
  static constexpr int digits = 4;
  static double rounded(double value) { return std::stod(fmt::format("{:.{}g}", value, digits)); }
  /// "walk_maxForward": without dots, which in a file would be maps within maps.
  static std::string nameOf(std::string path) {
    std::ranges::replace(path, '.', '_');
    return path;
  }

  Group first_;
  std::vector<std::string> written_;  ///< to the file
  std::vector<std::string> paths_;    ///< searched
  std::vector<TaskParameter> parameters_;
};

}  // namespace plumbline::training
