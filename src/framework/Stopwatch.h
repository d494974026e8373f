#pragma once
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace plumbline {

/// Statistics of a duration, added to by one thread, readable by all. Times are only ever reported: nothing
/// an agent does depends on them.
class Stopwatch {
public:
  /// One more duration [ns].
  void add(std::uint64_t nanoseconds) {
    bump(count_, 1);
    bump(sum_, nanoseconds);
    if (nanoseconds < min_.load(std::memory_order_relaxed))
      min_.store(nanoseconds, std::memory_order_relaxed);
    if (nanoseconds > max_.load(std::memory_order_relaxed))
      max_.store(nanoseconds, std::memory_order_relaxed);
    bump(bins_[bin(nanoseconds)], 1);
  }

  std::uint64_t count() const { return count_.load(std::memory_order_relaxed); }
  /// [s]; 0 if nothing was measured.
  double mean() const;
  double min() const {
    return count() == 0 ? 0 : 1e-9 * static_cast<double>(min_.load(std::memory_order_relaxed));
  }
  double max() const { return 1e-9 * static_cast<double>(max_.load(std::memory_order_relaxed)); }
  double total() const { return 1e-9 * static_cast<double>(sum_.load(std::memory_order_relaxed)); }
  /// [s] that the given part (0 to 1) of all durations does not exceed, at most 12.5 % too high.
  double percentile(double part) const;

private:
  // Eight bins per doubling.
  static constexpr unsigned fractionBits = 3;
  static constexpr std::size_t binCount = (64 - fractionBits + 1) << fractionBits;
  static std::size_t bin(std::uint64_t value) {
    if (value < (1u << fractionBits)) return value;
    const unsigned shift = static_cast<unsigned>(std::bit_width(value)) - 1 - fractionBits;
    return ((shift + 1) << fractionBits) + ((value >> shift) & ((1u << fractionBits) - 1));
  }
  static double upperEnd(std::size_t bin);
  /// There is only one writer: no locked instruction is needed.
  static void bump(std::atomic<std::uint64_t>& value, std::uint64_t by) {
    value.store(value.load(std::memory_order_relaxed) + by, std::memory_order_relaxed);
  }

  std::atomic<std::uint64_t> count_{0}, sum_{0}, min_{~std::uint64_t{0}}, max_{0};
  std::array<std::atomic<std::uint64_t>, binCount> bins_{};
};

}  // namespace plumbline
