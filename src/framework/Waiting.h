#pragma once
#include <chrono>
#include <cstdint>

namespace plumbline {

/// Marks code in which a module only waits, for input or for a time; busy times do not include it. Adds up
/// per thread; one within another counts once.
class Waiting {
public:
  Waiting() : begin_(std::chrono::steady_clock::now()) { depth_++; }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;
  ~Waiting() {
    if (--depth_ > 0) return;
    nanoseconds_ += static_cast<std::uint64_t>(
        std::chrono::nanoseconds(std::chrono::steady_clock::now() - begin_).count());
  }

  /// What this thread waited since the last call [ns].
  static std::uint64_t take() {
    const std::uint64_t taken = nanoseconds_;
    nanoseconds_ = 0;
    return taken;
  }

private:
  static inline thread_local std::uint64_t nanoseconds_ = 0;
  static inline thread_local unsigned depth_ = 0;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace plumbline
