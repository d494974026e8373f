#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline {

/// What is left to look at when the agent is dead: the last log messages and the step each thread is in.
/// Plain memory without pointers, so that it can be shared with the process that writes crash.log.
class CrashRecord {
public:
  static constexpr std::size_t messages = 512;
  static constexpr std::size_t messageLength = 500;
  static constexpr std::size_t threads = 16;
  static constexpr std::size_t steps = 1024;
  static constexpr std::size_t labelLength = 96;

  /// Keeps a message; the oldest one goes. Lock-free, from any thread; too long ones are cut.
  void add(std::string_view source, std::string_view message);
  /// The messages kept, oldest first, each as `[source] message`.
  std::string lastMessages() const;

  /// A place for a running thread, or -1 if all are taken; removeThread gives it back.
  int addThread(std::string_view name);
  void removeThread(int thread);
  /// A place for a step's label such as `Module:execute` (always the same one), or 0 (no label) if all are
  /// taken.
  std::uint32_t addStep(std::string_view label);
  /// What the thread does from now on; 0 for nothing.
  void setStep(int thread, std::uint32_t step) {
    if (thread >= 0) threads_[static_cast<std::size_t>(thread)].step.store(step, std::memory_order_relaxed);
  }
  /// The calling thread has this place until it enters another; currentThread gives it back, -1 for other
  /// threads.
  static void enterThread(int thread);
  static int currentThread();
  /// The label of what the thread does, or null; safe in a signal handler.
  const char* stepOf(int thread) const;
  /// Where each thread is: `[thread] Module:execute`, a line each.
  std::string whereabouts() const;

  /// The signal that ended the agent; 0 before.
  std::atomic<int> signal{0};
  /// The place of the thread it struck in, or -1.
  std::atomic<int> signalThread{-1};
  /// The addresses of the calls that led to the signal, innermost first.
  std::array<void*, 40> calls{};
  std::atomic<int> callCount{0};
  /// Set when the agent ends in order: then there is nothing to write.
  std::atomic<bool> finished{false};

private:
  struct Message {
    std::atomic<std::uint64_t> number{0};  // 0 while being written
    std::array<char, messageLength> text;
  };
  struct Thread {
    std::atomic<bool> taken{false};
    std::atomic<std::uint32_t> step{0};
    std::array<char, labelLength> name;
  };
  std::atomic<std::uint64_t> next_{1};
  std::atomic<std::uint32_t> stepCount_{1};
  std::array<Message, messages> messages_;
  std::array<Thread, threads> threads_;
  std::array<std::array<char, labelLength>, steps> steps_{};
};

/// The calling thread's place in the record, from here to the end of the block.
class CrashPlace {
public:
  CrashPlace(CrashRecord& record, std::string_view threadName);
  ~CrashPlace();
  CrashPlace(const CrashPlace&) = delete;
  CrashPlace& operator=(const CrashPlace&) = delete;

  /// What the thread does from now on.
  void enter(std::string_view label) { record_.setStep(thread_, record_.addStep(label)); }

private:
  CrashRecord& record_;
  int before_;
  int thread_;
};

}  // namespace plumbline
