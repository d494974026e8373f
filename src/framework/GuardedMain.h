#pragma once

namespace plumbline {

/// What the main() of every program is: runs `run` and turns whatever comes out of it into an exit status and
/// at most one line on stderr, "PROGRAM: what went wrong".
///
///     int main(int argc, char** argv) { return plumbline::guardedMain("gap", run, argc, argv); }
///
/// ConfigurationError: 2. Stopped: 130. No memory left, also in a thread of the program's own: 2 and
/// "PROGRAM: out of memory". Every other exception: `fault`. What was printed but could not be written (a
/// full disk, a closed pipe): 2.
int guardedMain(const char* program, int (*run)(int, char**), int argc, char** argv, int fault = 2) noexcept;

}  // namespace plumbline
