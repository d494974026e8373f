#pragma once
#include <exception>
#include <string>

namespace plumbline {

/// The text as one line that a terminal shows as it is: control characters become spaces, those at the end
/// go, and what is longer than a screen full (1000 bytes) ends with "...". For errors that quote what came
/// from outside.
std::string singleLine(std::string text);

/// What an exception says, as such a line: "out of memory" where none was left, and of the file system's
/// "PATH: REASON" without the name of the library's function.
std::string errorLine(const std::exception& error);

}  // namespace plumbline
