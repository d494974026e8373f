#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::fuzz {

/// A reader of what comes from outside, and inputs it knows. run() takes any bytes: it may refuse them, but
/// neither crash, nor hang, nor throw; a throw of Broken says that the reader contradicts itself.
struct Target {
  const char* name;
  void (*run)(std::string_view bytes);
  std::vector<std::string> (*seeds)();
  int rounds;  ///< mutations in the bounded run of the tests
};

/// All that are linked, by name.
const std::vector<Target>& targets();

/// Puts a target among them: one line at the end of its file.
///
///     const Registered here({"robotFile", robotFile, robotSeeds, 1200});
struct Registered {
  explicit Registered(const Target& target);
};

struct Broken : std::logic_error {
  using std::logic_error::logic_error;
};
inline void require(bool holds, const char* what) {
  if (!holds) throw Broken(what);
}

}  // namespace plumbline::fuzz
