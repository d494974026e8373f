#pragma once
#include <chrono>
#include <cstdint>

namespace plumbline {

/// Marks code in which a module only waits, for input or for a time; busy times do not include it. Adds up
/// per thread; one within another counts once.
class Waiting {
public:
  Waiting() : begin_(std::chrono::steady_clock::now()) { depth++; }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;
  ~Waiting() {
    if (--depth > 0) return;
    nanoseconds += static_cast<std::uint64_t>(
        std::chrono::nanoseconds(std::chrono::steady_clock::now() - begin_).count());
  }

  /// What this thread waited since the last call [ns].
  static std::uint64_t take() {
    const std::uint64_t taken = nanoseconds;
    nanoseconds = 0;
    return taken;
  }

private:
  static inline thread_local std::uint64_t nanoseconds = 0;
  static inline thread_local unsigned depth = 0;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace plumbline
