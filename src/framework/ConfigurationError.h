#pragma once
#include <stdexcept>
#include <string>

namespace plumbline {

/// Something a user wrote cannot be used: a line of modules.cfg, a config value, an option. what() is one
/// line that says what, where (file:line) and what to do; main prints it and exits with status 2.
class ConfigurationError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
  static constexpr int exitCode = 2;
};

}  // namespace plumbline
