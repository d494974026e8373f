#include "modules/watcher/WallClock.h"

#include <thread>

namespace plumbline {

MAKE_MODULE(WallClock)

void WallClock::execute() {
  std::this_thread::sleep_until(next_);
  const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / rate));
  const Clock::time_point now = Clock::now();
  next_ = (next_ + period > now ? next_ : now) + period;
}

void WallClock::update(FrameInfo* theFrameInfo) {
  const double now = std::chrono::duration<double>(Clock::now() - start_).count();
  theFrameInfo->cycleSeconds = cycle_ > 0 ? now - theFrameInfo->time : 1 / rate;
  theFrameInfo->time = now;
  theFrameInfo->cycle = ++cycle_;
}

}  // namespace plumbline
