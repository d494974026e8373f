#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>

namespace plumbline {

/// For what registers itself before main: ends the program with status 2, because two of a kind ("modules")
/// have the same name.
[[noreturn]] inline void endLinkedTwice(const char* kind, const std::string& name) {
  std::fprintf(stderr, "two %s with the name %s are linked into this program\n", kind, name.c_str());
  std::exit(2);
}

}  // namespace plumbline
