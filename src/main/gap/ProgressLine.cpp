#include "main/gap/ProgressLine.h"

#include <unistd.h>

#include <cstdio>

#include "framework/ProgressReport.h"

namespace plumbline::gap {

namespace {

using Seconds = ProgressReport::Seconds;
constexpr Seconds rewritten(0.1), alive(1), elsewhere = ProgressReport::longestSilence;

}  // namespace

ProgressLine::ProgressLine(bool quiet) : shown_(!quiet), inPlace_(isatty(STDERR_FILENO) != 0) {
  if (!shown_) return;
  ticker_ = std::jthread([this](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      ended_.wait_for(lock, stop, inPlace_ ? alive : elsewhere, [] { return false; });
      if (!stop.stop_requested() && !stage_.empty()) write();
    }
  });
}

ProgressLine::~ProgressLine() {
  if (ticker_.joinable()) {
    ticker_.request_stop();
    ticker_.join();
  }
  clear();
}

void ProgressLine::clear() {
  if (shown_ && inPlace_) std::fprintf(stderr, "\r\033[K");
}

void ProgressLine::write() {
  last_ = Clock::now();
  const double seconds = std::chrono::duration<double>(last_ - begin_).count();
  std::fprintf(stderr, inPlace_ ? "\r\033[K%s: %.0f %%, %.0f s" : "gap: %s: %.0f %%, %.0f s\n",
               stage_.c_str(), 100 * done_, seconds);
  std::fflush(stderr);
}

void ProgressLine::update(const std::string& what, double share) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  stage_ = what;
  done_ = share;
  if (inPlace_ && Clock::now() - last_ >= rewritten) write();
}

void ProgressLine::say(const std::string& text) {
  const std::lock_guard lock(mutex_);
  clear();
  std::fprintf(stderr, "gap: %s\n", text.c_str());
}

}  // namespace plumbline::gap
