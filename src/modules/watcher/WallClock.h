#pragma once
#include <chrono>

#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"

namespace plumbline {

MODULE(WallClock)
  PROVIDES(FrameInfo)
  PARAMETER(double, rate, 50, "Hz", Range(0.1, 1000), "cycles per second")
END_MODULE

/// The time of an agent without a robot: one that looks at another over the network. Keeps its thread to the
/// rate; a cycle that comes late is not made up for.
class WallClock : public WallClockBase {
public:
  void execute() override;
  void update(FrameInfo* theFrameInfo) override;

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), next_ = start_;
  unsigned cycle_ = 0;
};

}  // namespace plumbline
