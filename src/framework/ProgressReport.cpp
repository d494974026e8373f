#include "framework/ProgressReport.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace plumbline {

ProgressReport::ProgressReport(std::string program, Seconds first, Seconds interval)
    : program_(std::move(program)), thread_([this, first, interval] { run(first, interval); }) {}

ProgressReport::~ProgressReport() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  wake_.notify_all();
}

void ProgressReport::update(const std::string& stage, double share) {
  const std::lock_guard lock(mutex_);
  if (stage != stage_) {
    stage_ = stage;
    firstShare_ = share;
    begin_ = std::chrono::steady_clock::now();
  }
  share_ = share;
}

void ProgressReport::run(Seconds first, Seconds interval) {
  std::unique_lock lock(mutex_);
  for (Seconds pause = first; !wake_.wait_for(lock, pause, [this] { return end_; }); pause = interval)
    if (!stage_.empty()) std::fprintf(stderr, "%s\n", line().c_str());
}

std::string ProgressReport::line() const {
  const double elapsed = Seconds(std::chrono::steady_clock::now() - begin_).count();
  std::string text = program_ + ": " + stage_;
  if (share_ < 0) return text + ", for " + durationText(elapsed);
  char percent[32];
  std::snprintf(percent, sizeof percent, ": %.0f %%", 100 * share_);
  text += percent;
  const double done = share_ - firstShare_;
  if (done > 0) text += ", about " + durationText(elapsed * (1 - share_) / done) + " left";
  return text;
}

std::string durationText(double seconds) {
  char text[32];
  if (seconds < 100)
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  else if (seconds < 6000)
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  else
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  return text;
}

}  // namespace plumbline
