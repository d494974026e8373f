#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "parameters/Parameter.h"

namespace plumbline {

/// Options of a search task as a configuration or a server names them. A task declares its own as a struct of
/// PARAMETERS of the types double, int and text; an option of a group has no other name before it.
class TaskOptions {
public:
  TaskOptions() = default;
  explicit TaskOptions(std::map<std::string, std::string> values) : values_(std::move(values)) {}
  const std::map<std::string, std::string>& values() const { return values_; }

  /// The struct with the options that are named here. Throws ConfigurationError "option KEY: ..." for a value
  /// that is none, and for an unknown option, with the nearest one.
  template <typename Owner>
  Owner as() const {
    Owner owner;
    read(Owner::parameterList(), &owner);
    return owner;
  }

  /// "KEY=VALUE" each, for representations, and back.
  std::vector<std::string> lines() const;
  static TaskOptions ofLines(const std::vector<std::string>& lines);

  /// The option type, where it is a number and named; else 0.
  int robotType() const;

private:
  void read(const ParameterList& declared, void* owner) const;

  std::map<std::string, std::string> values_;
};

/// The names of the options whose value is not the declared one.
std::vector<std::string> changedOptions(const ParameterList& declared, void* owner);

/// The name of an option whose path in its struct this is: what stands behind the last dot.
std::string optionName(const std::string& path);

}  // namespace plumbline
