#pragma once
#include <chrono>
#include <map>
#include <memory>
#include <string>

#include "framework/Stopwatch.h"

namespace plumbline {

/// A module's debug object: the module's own stopwatches, which are listed with those of its execute and
/// updates in the timing report and in the debug interface (DebugSite.h holds the rest of that).
class Debug {
public:
  /// Measures until it is destroyed.
  class Measurement {
  public:
    explicit Measurement(Stopwatch& stopwatch) : stopwatch_(stopwatch), start_(Clock::now()) {}
    Measurement(const Measurement&) = delete;
    Measurement& operator=(const Measurement&) = delete;
    ~Measurement() {
      stopwatch_.add(static_cast<std::uint64_t>(std::chrono::nanoseconds(Clock::now() - start_).count()));
    }

  private:
    using Clock = std::chrono::steady_clock;
    Stopwatch& stopwatch_;
    Clock::time_point start_;
  };

  /// `auto watch = debug.stopwatch("resampling");` measures to the end of the block.
  [[nodiscard]] Measurement stopwatch(const std::string& name);
  const std::map<std::string, std::shared_ptr<Stopwatch>>& stopwatches() const { return stopwatches_; }

private:
  std::map<std::string, std::shared_ptr<Stopwatch>> stopwatches_;
};

}  // namespace plumbline
