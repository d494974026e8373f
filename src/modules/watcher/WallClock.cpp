#include "modules/watcher/WallClock.h"

#include <algorithm>
#include <thread>

namespace plumbline {

MAKE_MODULE(WallClock)

void WallClock::execute() {
  std::this_thread::sleep_until(next_);
  const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / rate));
  next_ = std::max(next_ + period, Clock::now());
}

void WallClock::update(FrameInfo* theFrameInfo) {
  const double now = std::chrono::duration<double>(Clock::now() - start_).count();
  theFrameInfo->cycleSeconds = cycle_ > 0 ? now - theFrameInfo->time : 1 / rate;
  theFrameInfo->time = now;
  theFrameInfo->cycle = ++cycle_;
}

}  // namespace plumbline
