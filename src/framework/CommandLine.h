#pragma once
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace plumbline {

/// What `--version` prints behind the program's name.
std::string versionText();

/// Reads a program's command line, in the same way for every program of bin/: adds `-h,--help` and
/// `--version` to what `app` declares, and names the nearest option or subcommand for one that does not
/// exist. Returns the exit status where the program has to end: 0 after help or version, 2 after a mistake,
/// which is one line on stderr. Exceptions of callbacks go through.
///
///     if (const auto status = readCommandLine(app, argc, argv)) return *status;
std::optional<int> readCommandLine(CLI::App& app, int argc, const char* const* argv);

/// The line for a mistake in the command line, without the program's name: used by readCommandLine, and by
/// programs that check more after it. `what` says what is wrong.
std::string commandLineError(const CLI::App& app, const std::string& what);

/// `status`, or 2 with a line on stderr if what was printed on stdout could not be written (a full disk, a
/// closed pipe). For the end of main.
int flushedStatus(const std::string& program, int status);

}  // namespace plumbline
