#pragma once
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace plumbline {

/// What is wrong with an option's text; empty: nothing.
using OptionCheck = std::function<std::string(const std::string& text)>;

/// Thrown by what an option calls (CommandLine::action): its text cannot be.
class OptionError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// An option, flag or argument of a CommandLine. Each function says more of it and returns it again. Copies
/// are the same option.
class CommandOption {
public:
  explicit CommandOption(CLI::Option& option) : option_(&option) {}

  const CommandOption& required() const;
  const CommandOption& needs(const CommandOption& other) const;
  const CommandOption& needs(const std::string& other) const;
  const CommandOption& excludes(const CommandOption& other) const;
  const CommandOption& excludes(const std::string& other) const;

  /// The help shows the variable's value now, or this text; it is what an option without its value means.
  const CommandOption& showDefault() const;
  const CommandOption& showDefault(const std::string& text) const;

  const CommandOption& valueOptional() const;
  /// Of a list: each value has the option's name before it, or all are one word with commas.
  const CommandOption& oneValueEach() const;
  const CommandOption& byCommas() const;
  /// The variable of the environment that says it where the command line does not.
  const CommandOption& orVariable(const std::string& name) const;
  /// Sets `given` if the option is in the line.
  const CommandOption& notes(bool& given) const;
  /// Calls its action when it is read, before what follows it.
  const CommandOption& atOnce() const;

  const CommandOption& check(OptionCheck problem) const;
  const CommandOption& range(int least, int most) const;
  const CommandOption& range(unsigned least, unsigned most) const;
  const CommandOption& range(double least, double most) const;
  const CommandOption& notNegative() const;
  /// A TCP or UDP port, from 1; portOrFree(): 0, too, which means a free one.
  const CommandOption& port() const;
  const CommandOption& portOrFree() const;
  const CommandOption& oneOf(const std::vector<std::string>& words) const;
  const CommandOption& existingFile() const;
  const CommandOption& existingFolder() const;

  /// After the command line was read.
  bool given() const;

private:
  friend class CommandLine;
  CLI::Option* option_;
};

}  // namespace plumbline
