#include "record/Recorder.h"

#include <chrono>
#include <stdexcept>

#include "framework/ThreadPriority.h"

namespace plumbline::record {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds interval{50}, commitInterval{250};
constexpr int stepsOfNice = 4;

std::string counted(std::uint64_t count) {
  return std::to_string(count) + (count == 1 ? " cycle is" : " cycles are");
}

}  // namespace

Recorder::Recorder(const std::string& folder, RecorderOptions options, Notify notify)
    : options_(options), notify_(std::move(notify)), writer_(folder, options.writer) {
  thread_ = std::thread([this] {
    applyThreadPriority(0, stepsOfNice);
    work();
  });
}

Recorder::~Recorder() { finish(); }

ThreadRecorder& Recorder::addThread(RecordedThread thread, std::vector<Representation*> values) {
  const std::lock_guard lock(mutex_);
  threads_.push_back(std::make_unique<ThreadRecorder>(std::move(thread), std::move(values),
                                                      options_.bufferBytes, options_.waits));
  return *threads_.back();
}

std::uint64_t Recorder::dropped() const {
  const std::lock_guard lock(mutex_);
  std::uint64_t count = lost_;
  for (const auto& thread : threads_) count += thread->dropped();
  return count;
}

void Recorder::fail(const std::string& error) {
  failed_ = true;
  for (const auto& thread : threads_) thread->close();
  if (notify_) notify_("log: " + error + "; nothing more is recorded");
}

bool Recorder::drain() {
  bool any = false;
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    // Takes only what was there: so the other threads have their turn, and the end is noticed.
    for (int taken = 0; taken < 1000 && threads_[i]->take(view_); ++taken) {
      any = true;
      view_.thread = i;
      if (failed_) {
        lost_++;
        continue;
      }
      try {
        if (!begun_) {
          std::vector<RecordedThread> threads;
          for (const auto& thread : threads_) threads.push_back(thread->thread());
          writer_.begin(std::move(threads));
          begun_ = true;
        }
        writer_.write(view_);
        cycles_.fetch_add(1);
      } catch (const std::runtime_error& error) {
        lost_++;
        fail(error.what());
      }
    }
  }
  return any;
}

void Recorder::updateStatistics(bool last) {
  const std::uint64_t missing = dropped();
  if (missing > 0 && !reportedDropped_ && !failed_ && notify_) {
    notify_("log: the buffer is full, cycles are dropped");
    reportedDropped_ = true;
  }
  if (last && missing > 0 && notify_) notify_("log: " + counted(missing) + " missing in " + writer_.folder());
  if (failed_ || !begun_) return;
  try {
    if (missing != noted_) writer_.noteDropped(missing);
    noted_ = missing;
    writer_.commit();
    if (last) writer_.finish();
  } catch (const std::runtime_error& error) {
    fail(error.what());
  }
}

void Recorder::work() {
  auto committed = Clock::now();
  std::unique_lock lock(mutex_);
  for (;;) {
    const bool last = ends_;
    lock.unlock();
    const bool any = drain();
    if (last && !any) break;
    if (Clock::now() - committed > commitInterval) {
      updateStatistics(false);
      committed = Clock::now();
    }
    lock.lock();
    if (!any) wake_.wait_for(lock, interval, [this] { return ends_; });
  }
  updateStatistics(true);
}

void Recorder::finish() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

}  // namespace plumbline::record
