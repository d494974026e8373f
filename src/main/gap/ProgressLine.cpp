#include "main/gap/ProgressLine.h"

#include <unistd.h>

#include <cstdio>

namespace plumbline::gap {

namespace {

using std::chrono::milliseconds;
constexpr milliseconds rewritten(100), alive(1000), elsewhere(10000);

}  // namespace

ProgressLine::ProgressLine(bool quiet) : shown(!quiet), inPlace(isatty(STDERR_FILENO) != 0) {
  if (!shown) return;
  ticker = std::jthread([this](const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      ended.wait_for(lock, stop, inPlace ? alive : elsewhere, [] { return false; });
      if (!stop.stop_requested() && !stage.empty()) write();
    }
  });
}

ProgressLine::~ProgressLine() {
  if (ticker.joinable()) {
    ticker.request_stop();
    ticker.join();
  }
  clear();
}

void ProgressLine::clear() {
  if (shown && inPlace) std::fprintf(stderr, "\r\033[K");
}

void ProgressLine::write() {
  last = Clock::now();
  const double seconds = std::chrono::duration<double>(last - begin).count();
  std::fprintf(stderr, inPlace ? "\r\033[K%s: %.0f %%, %.0f s" : "gap: %s: %.0f %%, %.0f s\n", stage.c_str(),
               100 * done, seconds);
  std::fflush(stderr);
}

void ProgressLine::tell(const std::string& what, double share) {
  if (!shown) return;
  const std::lock_guard lock(mutex);
  stage = what;
  done = share;
  if (inPlace && Clock::now() - last >= rewritten) write();
}

void ProgressLine::say(const std::string& text) {
  const std::lock_guard lock(mutex);
  clear();
  std::fprintf(stderr, "gap: %s\n", text.c_str());
}

}  // namespace plumbline::gap
