#include "framework/CommandOption.h"

#include <CLI/CLI.hpp>

namespace plumbline {
namespace {
constexpr int largestPort = 65535;
}

const CommandOption& CommandOption::required() const {
  option_->required();
  return *this;
}

const CommandOption& CommandOption::needs(const CommandOption& other) const {
  option_->needs(other.option_);
  return *this;
}

const CommandOption& CommandOption::needs(const std::string& other) const {
  option_->needs(other);
  return *this;
}

const CommandOption& CommandOption::excludes(const CommandOption& other) const {
  option_->excludes(other.option_);
  return *this;
}

const CommandOption& CommandOption::excludes(const std::string& other) const {
  option_->excludes(other);
  return *this;
}

const CommandOption& CommandOption::showDefault() const {
  option_->capture_default_str();
  return *this;
}

const CommandOption& CommandOption::showDefault(const std::string& text) const {
  option_->default_str(text);
  return *this;
}

const CommandOption& CommandOption::valueOptional() const {
  option_->expected(0, 1);
  return *this;
}

const CommandOption& CommandOption::oneValueEach() const {
  option_->allow_extra_args(false);
  return *this;
}

const CommandOption& CommandOption::byCommas() const {
  option_->delimiter(',');
  return *this;
}

const CommandOption& CommandOption::orVariable(const std::string& name) const {
  option_->envname(name);
  return *this;
}

const CommandOption& CommandOption::notes(bool& given) const {
  option_->each([&given](const std::string&) { given = true; });
  return *this;
}

const CommandOption& CommandOption::atOnce() const {
  option_->trigger_on_parse();
  return *this;
}

const CommandOption& CommandOption::check(OptionCheck problem) const {
  option_->check(
      CLI::Validator([problem = std::move(problem)](std::string& text) { return problem(text); }, ""));
  return *this;
}

const CommandOption& CommandOption::range(int least, int most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

const CommandOption& CommandOption::range(unsigned least, unsigned most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

const CommandOption& CommandOption::range(double least, double most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

const CommandOption& CommandOption::notNegative() const {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}

const CommandOption& CommandOption::port() const { return range(1, largestPort); }
const CommandOption& CommandOption::portOrFree() const { return range(0, largestPort); }

const CommandOption& CommandOption::oneOf(const std::vector<std::string>& words) const {
  option_->check(CLI::IsMember(words));
  return *this;
}

const CommandOption& CommandOption::existingFile() const {
  option_->check(CLI::ExistingFile);
  return *this;
}

const CommandOption& CommandOption::existingFolder() const {
  option_->check(CLI::ExistingDirectory);
  return *this;
}

bool CommandOption::given() const { return option_->count() > 0; }

}  // namespace plumbline
