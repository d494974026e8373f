#pragma once
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "record/LogWriter.h"
#include "record/ThreadRecorder.h"

namespace plumbline::record {

struct RecorderOptions {
  LogWriterOptions writer{};
  std::size_t bufferBytes = std::size_t{8} << 20;  ///< for each thread of the agent
  bool waits = false;  ///< a full buffer holds the agent up instead of dropping cycles
};

/// Records an agent into a log, in a thread of its own; the agent's threads put their data into buffers. Data
/// older than half a second survives the end of the process. If the log can no longer be written, a message
/// says so once, and the agent continues without it.
class Recorder {
public:
  /// Takes a line for the user.
  using Notify = std::function<void(const std::string&)>;

  /// Makes the log's folder. Throws std::runtime_error, one line, if it cannot.
  Recorder(const std::string& folder, RecorderOptions options, Notify notify);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Call all before the first cycle of any thread. The values must live as long as they are recorded.
  ThreadRecorder& addThread(RecordedThread thread, std::vector<Representation*> values);
  /// From now on the agent waits when a buffer is full; call it before addThread.
  void wait() { options_.waits = true; }

  /// Writes the rest and ends; reports what is missing.
  void finish();
  /// After finish(): something could not be written, so that the log ends early.
  bool endsEarly() const { return failed_; }

  std::uint64_t cycles() const { return cycles_.load(); }
  std::uint64_t dropped() const;

private:
  void work();
  bool drain();
  void updateStatistics(bool last);
  void fail(const std::string& error);

  RecorderOptions options_;
  Notify notify_;
  LogWriter writer_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::vector<std::unique_ptr<ThreadRecorder>> threads_;
  bool begun_ = false, failed_ = false;
  std::uint64_t lost_ = 0;   ///< taken and not written
  std::uint64_t noted_ = 0;  ///< dropped cycles that the log knows of
  bool reportedDropped_ = false;
  std::atomic<std::uint64_t> cycles_{0};
  CycleView view_;
  std::thread thread_;
};

}  // namespace plumbline::record
