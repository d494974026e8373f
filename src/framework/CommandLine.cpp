#include "framework/CommandLine.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "framework/SingleLine.h"
#include "framework/Version.h"

namespace plumbline {
namespace {

/// CLI11's help without its notation for flags that switch off.
class HelpFormatter : public CLI::Formatter {
public:
  std::string make_option_name(const CLI::Option* option, bool isPositional) const override {
    std::string name = CLI::Formatter::make_option_name(option, isPositional);
    for (const std::string off = "{false}"; true;) {
      const std::size_t at = name.find(off);
      if (at == std::string::npos) return name;
      name.erase(at, off.size());
    }
  }
};

void prepare(CLI::App& app, const std::shared_ptr<CLI::FormatterBase>& formatter) {
  app.formatter(formatter);
  if (app.get_help_ptr()) app.set_help_flag("-h,--help", "Print this help");
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) prepare(*command, formatter);
}

/// The subcommand that the line got to.
const CLI::App& reached(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : reached(*commands.back());
}

std::string spelling(const std::string& bareName) { return (bareName.size() == 1 ? "-" : "--") + bareName; }

void addOptions(const CLI::App& app, std::vector<std::string>& names) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back(spelling(name));
  }
  for (const CLI::App* command : app.get_subcommands()) addOptions(*command, names);
}

/// The first word that no option and no argument took; empty if there is none. Of options the name alone.
std::string strayWord(const CLI::App& app) {
  for (const std::string& word : app.remaining(true)) {
    if (word.size() > 1 && word[0] == '-') return word.substr(0, word.find('='));
  }
  const auto words = app.remaining(true);
  return words.empty() ? "" : words.front();
}

std::string strayText(const CLI::App& app, const std::string& word) {
  const CLI::App& command = reached(app);
  std::vector<std::string> names;
  if (word.size() > 1 && word[0] == '-') {
    addOptions(app, names);
    return "there is no option " + word + suggestion(word, names);
  }
  for (const CLI::App* child : command.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(child->get_name());
  if (names.empty()) return "unexpected argument \"" + word + "\"";
  return "there is no command " + word + suggestion(word, names);
}

/// CLI11's "1 required FLOAT missing" in words.
std::string mismatchText(const CLI::App& app, const std::string& what) {
  const std::string name = what.substr(0, what.find(':'));
  const CLI::Option* option = reached(app).get_option_no_throw(name);
  const bool single =
      option && option->get_items_expected_min() == 1 && option->get_items_expected_max() == 1;
  return single ? name + " takes one value, once" : what;
}

}  // namespace

std::string versionText() { return "Plumbline " PLUMBLINE_VERSION; }

std::string commandLineError(const CLI::App& app, const std::string& what) {
  const std::string program = app.get_name();
  std::string command = program;
  for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().back();
    command += " " + at->get_name();
  }
  return singleLine(what) + "; see " + command + " --help";
}

std::optional<int> readCommandLine(CLI::App& app, int argc, const char* const* argv) {
  if (app.get_name().empty() && argc > 0) {
    const std::string path = argv[0];
    app.name(path.substr(path.rfind('/') + 1));
  }
  prepare(app, std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", app.get_name() + " (" + versionText() + ")", "Print the version");
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    // A misspelt word often leaves something else missing: it is the cause, so it is named.
    const std::string stray = strayWord(app);
    std::string what = error.what();
    if (!stray.empty())
      what = strayText(app, stray);
    else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
      what = mismatchText(app, what);
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), commandLineError(app, what).c_str());
    return ConfigurationError::exitCode;
  }
}

int flushedStatus(const std::string& program, int status) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
  std::fprintf(stderr, "%s: cannot write to standard output: %s\n", program.c_str(), std::strerror(errno));
  return ConfigurationError::exitCode;
}

}  // namespace plumbline
