#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/CommandOption.h"

namespace CLI {
class App;
}

namespace plumbline {

/// The options of a program or of one of its commands, and what its help says. Copies are the same command.
/// CLI11, which does the work, is compiled in two sources only: it costs seconds in each that includes it.
///
///     CommandLine line("What the program does.");
///     line.option("--seed", seed, "of the search").range(1, 100).showDefault();
///     if (const auto status = readCommandLine(line, argc, argv)) return *status;
class CommandLine {
public:
  /// `name`: of the program; by its path if it is empty.
  explicit CommandLine(const std::string& what, const std::string& name = "");

  /// An option ("-o,--output") or argument ("folder") that sets a variable: a text, a number, a list of
  /// texts or numbers, or one of them that is optional; CommandLine.cpp says which there are.
  template <typename T>
  CommandOption option(const std::string& names, T& value, const std::string& what);
  /// "--name,!--no-name" has a name that switches off.
  CommandOption flag(const std::string& names, bool& value, const std::string& what);
  /// An option whose text is passed on.
  CommandOption action(const std::string& names, std::function<void(const std::string&)> take,
                       const std::string& what);
  /// The same for one that may be repeated: all its texts.
  CommandOption actionOnAll(const std::string& names,
                            std::function<void(const std::vector<std::string>&)> take,
                            const std::string& what);
  /// Whether an option stood in the line that was read.
  bool given(const std::string& name) const;

  /// A command of its own, as `record` of bin/gap; `run` is called when the line was read.
  CommandLine command(const std::string& name, const std::string& what);
  void whenChosen(std::function<void()> run);
  void requireCommand();
  /// Options of this command may follow its commands, too.
  void shareOptions();

  /// Lines at the end of the help: examples.
  void footer(const std::string& text);

private:
  friend std::optional<int> readCommandLine(CommandLine& line, int argc, const char* const* argv);
  friend std::string commandLineError(const CommandLine& line, const std::string& what);
  explicit CommandLine(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}

  std::shared_ptr<CLI::App> app_;
};

/// What `--version` prints behind the program's name.
std::string versionText();

/// Reads a program's command line, in the same way for every program of bin/: adds `-h,--help` and
/// `--version` to what `line` declares, and names the nearest option or subcommand for one that does not
/// exist. Returns the exit status where the program has to end: 0 after help or version, 2 after a mistake,
/// which is one line on stderr. Exceptions of actions go through.
std::optional<int> readCommandLine(CommandLine& line, int argc, const char* const* argv);

/// The line for a mistake in the command line, without the program's name: used by readCommandLine, and by
/// programs that check more after it. `what` says what is wrong.
std::string commandLineError(const CommandLine& line, const std::string& what);

/// `status`, or 2 with a line on stderr if what was printed on stdout could not be written (a full disk, a
/// closed pipe). For the end of main.
int flushedStatus(const std::string& program, int status);

}  // namespace plumbline
