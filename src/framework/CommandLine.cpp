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

void share(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    command->fallthrough();
    share(*command);
  }
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

std::string errorText(const CLI::App& app, const std::string& what) {
  std::string command = app.get_name();
  for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().back();
    command += " " + at->get_name();
  }
  return singleLine(what) + "; see " + command + " --help";
}

/// Calls what an option calls; CLI11 reads on for its own errors only.
template <typename Text>
std::function<void(const Text&)> taking(const std::string& names, std::function<void(const Text&)> take) {
  return [names, take = std::move(take)](const Text& text) {
    try {
      take(text);
    } catch (const OptionError& error) {
      throw CLI::ValidationError(names, error.what());
    }
  };
}

}  // namespace

CommandLine::CommandLine(const std::string& what, const std::string& name)
    : app_(std::make_shared<CLI::App>(what, name)) {}

template <typename T>
CommandOption CommandLine::option(const std::string& names, T& value, const std::string& what) {
  return CommandOption(*app_->add_option(names, value, what));
}
template CommandOption CommandLine::option(const std::string&, std::string&, const std::string&);
template CommandOption CommandLine::option(const std::string&, int&, const std::string&);
template CommandOption CommandLine::option(const std::string&, unsigned&, const std::string&);
template CommandOption CommandLine::option(const std::string&, std::uint64_t&, const std::string&);
template CommandOption CommandLine::option(const std::string&, std::optional<std::uint64_t>&,
                                           const std::string&);
template CommandOption CommandLine::option(const std::string&, double&, const std::string&);
template CommandOption CommandLine::option(const std::string&, std::vector<std::string>&, const std::string&);

CommandOption CommandLine::flag(const std::string& names, bool& value, const std::string& what) {
  return CommandOption(*app_->add_flag(names, value, what));
}

CommandOption CommandLine::action(const std::string& names, std::function<void(const std::string&)> take,
                                  const std::string& what) {
  return CommandOption(*app_->add_option_function<std::string>(names, taking(names, std::move(take)), what));
}

CommandOption CommandLine::actionOnAll(const std::string& names,
                                       std::function<void(const std::vector<std::string>&)> take,
                                       const std::string& what) {
  return CommandOption(
      *app_->add_option_function<std::vector<std::string>>(names, taking(names, std::move(take)), what)
           ->take_all());
}

bool CommandLine::given(const std::string& name) const { return app_->get_option(name)->count() > 0; }

CommandLine CommandLine::command(const std::string& name, const std::string& what) {
  return CommandLine(app_->get_subcommand_ptr(app_->add_subcommand(name, what)));
}

void CommandLine::whenChosen(std::function<void()> run) { app_->callback(std::move(run)); }
void CommandLine::requireCommand() { app_->require_subcommand(1); }
void CommandLine::shareOptions() { share(*app_); }
void CommandLine::footer(const std::string& text) { app_->footer(text); }

std::string versionText() { return "Plumbline " PLUMBLINE_VERSION; }

std::string commandLineError(const CommandLine& line, const std::string& what) {
  return errorText(*line.app_, what);
}

std::optional<int> readCommandLine(CommandLine& line, int argc, const char* const* argv) {
  CLI::App& app = *line.app_;
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
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), errorText(app, what).c_str());
    return ConfigurationError::exitCode;
  }
}

int flushedStatus(const std::string& program, int status) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
  std::fprintf(stderr, "%s: cannot write to standard output: %s\n", program.c_str(), std::strerror(errno));
  return ConfigurationError::exitCode;
}

}  // namespace plumbline
