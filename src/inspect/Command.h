#pragma once
#include <string>
#include <string_view>

#include "inspect/Requests.h"
#include "inspect/Tree.h"

namespace plumbline::inspect {

/// A line of a client, taken apart.
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
    none
  };
  Verb verb = Verb::none;
  std::string tag;   ///< of `#TAG `; empty: none
  std::string name;  ///< a value's or block's with its part, a prefix, or a format
  Tree value{};      ///< of set
  Interval interval{};
  std::string error;  ///< not empty: the line is no command
};

Command parseCommand(std::string_view line);

/// What `help` says.
std::string_view commandHelp();

}  // namespace plumbline::inspect
