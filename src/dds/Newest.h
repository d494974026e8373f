#pragma once
#include <array>
#include <atomic>

namespace plumbline::dds {

/// Hands the newest value from one thread to another; neither waits. Three values change hands by one
/// exchange, as in framework/ThreadCopy.h.
template <typename T>
class Newest {
public:
  template <typename... Arguments>
  explicit Newest(const Arguments&... arguments)
      : values_{T(arguments...), T(arguments...), T(arguments...)} {}

  /// The thread that writes: a value of some time ago, to be overwritten and then published.
  T& writing() { return values_[writing_]; }
  void publish() { writing_ = middle_.exchange(writing_ | fresh, std::memory_order_acq_rel) & indexMask; }

  /// The thread that reads: false if nothing was published since the last call; otherwise reading() is the
  /// newest.
  bool take() {
    if (!(middle_.load(std::memory_order_relaxed) & fresh)) return false;
    reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & indexMask;
    return true;
  }
  T& reading() { return values_[reading_]; }

private:
  static constexpr unsigned indexMask = 3, fresh = 4;

  std::array<T, 3> values_;
  unsigned writing_ = 0, reading_ = 2;
  std::atomic<unsigned> middle_{1};
};

}  // namespace plumbline::dds
