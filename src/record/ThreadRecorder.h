#pragma once
#include <atomic>
#include <cstdint>
#include <string_view>
#include <vector>

#include "framework/Representation.h"
#include "record/CdrStream.h"
#include "record/CycleRing.h"
#include "record/LogWriter.h"
#include "record/RecordedThread.h"

namespace plumbline::record {

/// The part of a recorder in one thread of the agent: copies the representations at the end of a cycle
/// and passes them on without waiting.
class ThreadRecorder {
public:
  ThreadRecorder(RecordedThread thread, std::vector<Representation*> values, std::size_t bufferBytes,
                 bool waits);

  /// At the end of a cycle; `timestamp` in nanoseconds. Where there is no room, the cycle is counted as
  /// dropped, or, for a recorder that waits, taken later.
  void record(std::int64_t timestamp);

  // The writer's side.
  const RecordedThread& thread() const { return thread_; }
  /// The next cycle, valid until the next call. False: there is none yet.
  bool take(CycleView& cycle);
  std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }
  /// No cycles are taken any more: all are dropped.
  void close() { closed_.store(true, std::memory_order_relaxed); }

private:
  struct Header {
    std::uint64_t number;
    std::int64_t timestamp;
  };

  RecordedThread thread_;
  std::vector<Representation*> values_;
  CycleRing ring_;
  bool waits_;
  CdrOutStream out_;
  std::vector<std::uint32_t> sizes_;
  std::uint64_t number_ = 0;
  std::string taken_;
  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<bool> closed_{false};
};

}  // namespace plumbline::record
