#pragma once
#include <span>
#include <string>
#include <string_view>

#include "inspect/Requests.h"
#include "inspect/Tree.h"

namespace plumbline::inspect {

/// A line of a client, split into its parts.
struct Command {
  enum class Verb {
    get,
    watch,
    unwatch,
    set,
    setOnce,
    unset,
    run,
    runOnce,
    runOff,
    list,
    complete,
    format,
    timing,
    graph,
    about,
    providers,
    help,
    commands,
    none
  };
  Verb verb = Verb::none;
  std::string tag;   ///< of `#TAG `; empty: none
  std::string name;  ///< a value's or block's with its part, a prefix, or a format; complete: what was typed
  Tree value{};      ///< of set
  Interval interval{};
  std::string error;  ///< not empty: the line is no command
};

Command parseCommand(std::string_view line);

/// The argument that a command may have.
enum class Argument {
  nothing,
  value,           ///< what can be read
  settable,        ///< a value or parameter that can be set
  pending,         ///< one that is set
  watched,         ///< what this client watches
  block,           ///< a block of code or a drawing
  module,          ///< of reset
  file,            ///< of reload
  name,            ///< any of all names
  parameter,       ///< of about
  representation,  ///< of providers
  stopwatch,       ///< of timing
  format,          ///< text or json
  command,         ///< of help
};

/// A command as `commands` prints it: "get VALUE".
struct CommandForm {
  std::string_view word, usage;
  Argument argument;
  Command::Verb verb;
  bool needsName = false;  ///< its argument may not be left out
};
std::span<const CommandForm> commandForms();

/// The text of `help`.
std::string_view commandHelp();

}  // namespace plumbline::inspect
