#include "dds/SendingThread.h"

#include "framework/ThreadPriority.h"

namespace plumbline::dds {

void SendingThread::wake() {
  std::call_once(started_, [this] { thread_ = std::thread([this] { run(); }); });
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_one();
}

void SendingThread::run() {
  constexpr int stepsOfNice = 14;
  applyThreadPriority(0, stepsOfNice);
  for (unsigned seen = 0;;) {
    calls_.wait(seen, std::memory_order_acquire);
    seen = calls_.load(std::memory_order_acquire);
    if (ends_) return;
    send_();
  }
}

SendingThread::~SendingThread() {
  if (!thread_.joinable()) return;
  ends_ = true;
  wake();
  thread_.join();
}

}  // namespace plumbline::dds
