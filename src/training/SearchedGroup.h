#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "framework/ModuleParameters.h"
#include "parameters/Parameter.h"
#include "training/FirstSteps.h"
#include "training/GroupedLines.h"
#include "training/SearchTask.h"

namespace plumbline::training {

/// A parameter group of which a task searches some numbers, begun with a map of a configuration file. A run
/// has what the file would have: numbers of four digits. `among`: only those for which it holds are searched;
/// the others keep their values, and are written with them. Throws ConfigurationError for a step of no
/// number.
template <typename Group>
class SearchedGroup {
public:
  SearchedGroup(const ConfigSection& section, const std::vector<FirstStep>& steps,
                const std::function<bool(const std::string& path)>& among = {}) {
    readParameters(section, Group::parameterList(), &first_);
    std::vector<std::string> known;
    Group::parameterList().visit(&first_, [&](const std::string& path, const Parameter& parameter,
                                              const ParameterPointer& value) {
      const auto* const number = std::get_if<double*>(&value);
      if (!number) return;
      known.push_back(path);
      const auto one = std::ranges::find(steps, path, &FirstStep::path);
      if (one == steps.end()) return;
      written_.push_back(path);
      if (among && !among(path)) return;
      paths_.push_back(path);
      parameters_.push_back({nameOf(path), **number, parameter.range.min, parameter.range.max, one->size});
    });
    checkPaths(steps, known);
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
