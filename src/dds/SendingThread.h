#pragma once
#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace plumbline::dds {

/// A thread of low priority that sends when it is woken, so that no cycle waits for a network.
class SendingThread {
public:
  /// `send` is called in the thread; calls of wake() during one are answered by one more.
  explicit SendingThread(std::function<void()> send) : send_(std::move(send)) {}
  ~SendingThread();
  SendingThread(const SendingThread&) = delete;
  SendingThread& operator=(const SendingThread&) = delete;

  /// Any thread; starts the thread at the first call.
  void wake();

private:
  void run();

  std::function<void()> send_;
  std::once_flag started_;
  std::atomic<unsigned> calls_{0};
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace plumbline::dds
