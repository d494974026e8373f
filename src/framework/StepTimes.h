#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumbline {

/// Durations of a thread's steps [ns], a row for each cycle. A stopwatch is a histogram of 4 kB, and those of
/// all steps do not stay in the processor's cache from cycle to cycle: so they get their durations by many
/// rows at once.
class StepTimes {
public:
  using Clock = std::chrono::steady_clock;

  explicit StepTimes(std::size_t steps) : steps_(steps), times_(steps * mostRows) {}

  /// In the cycle that goes on.
  void put(std::size_t step, std::uint64_t nanoseconds) { times_[rows_ * steps_ + step] = nanoseconds; }
  std::uint64_t of(std::size_t step) const { return times_[rows_ * steps_ + step]; }

  /// The cycle is over. True if the rows are due: all of them are full, the oldest is old, or the thread has
  /// just begun.
  bool next(Clock::time_point now) {
    if (rows_ == 0) oldest_ = now;
    ++rows_;
    ++cycles_;
    return rows_ == mostRows || cycles_ <= mostRows || now - oldest_ >= longest;
  }

  /// Gives all durations of whole cycles to `give(step, nanoseconds)`, those of a step in their order, and
  /// forgets them.
  template <typename Give>
  void empty(Give&& give) {
    for (std::size_t step = 0; step < steps_; ++step)
      for (std::size_t row = 0; row < rows_; ++row) give(step, times_[row * steps_ + step]);
    rows_ = 0;
  }

private:
  static constexpr std::size_t mostRows = 64;
  static constexpr std::chrono::milliseconds longest{500};

  std::size_t steps_, rows_ = 0, cycles_ = 0;
  Clock::time_point oldest_;
  std::vector<std::uint64_t> times_;
};

}  // namespace plumbline
