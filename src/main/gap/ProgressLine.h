#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace plumbline::gap {

/// A line that says what is being done, rewritten in place where a person looks on.
class ProgressLine {
public:
  explicit ProgressLine(bool quiet) : shown(!quiet && isatty(STDERR_FILENO)) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void clear() {
    if (shown) std::fprintf(stderr, "\r\033[K");
  }

  void tell(const std::string& what, double share) {
    const auto now = std::chrono::steady_clock::now();
    if (!shown || now - last < std::chrono::milliseconds(100)) return;
    last = now;
    std::fprintf(stderr, "\r\033[K%s: %3.0f %%", what.c_str(), 100 * share);
    std::fflush(stderr);
  }

private:
  bool shown;
  std::chrono::steady_clock::time_point last;
};

}  // namespace plumbline::gap
