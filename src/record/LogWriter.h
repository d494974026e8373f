#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "record/BagFile.h"
#include "record/RecordedThread.h"

namespace plumbline::record {

struct LogWriterOptions {
  std::uint64_t fileBytes = std::uint64_t{512} << 20;  ///< a new file begins when one is about so large
  std::size_t files = 0;                               ///< the newest so many are kept; 0: all
};

/// A cycle of a thread, its messages in the order of the thread's topics.
struct CycleView {
  std::size_t thread = 0;
  std::uint64_t number = 0;
  std::int64_t timestamp = 0;  ///< [ns]
  std::vector<std::string_view> messages;
};

/// A log: a folder with metadata.yaml and files NAME_0.db3, NAME_1.db3, ..., as a bag of ROS 2. A message
/// that is the same as in the thread's cycle before is left out; every 250th cycle, and the first of each
/// file, has all. Throws std::runtime_error, one line, when nothing can be written.
class LogWriter {
public:
  static constexpr std::uint64_t completeEvery = 250;  ///< cycles

  /// Makes the folder, which must not be there.
  LogWriter(const std::string& folder, LogWriterOptions options);
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  /// Once, before the first cycle.
  void begin(std::vector<RecordedThread> threads);
  void write(const CycleView& cycle);
  /// All that was written up to now survives the end of the process.
  void commit();
  /// Cycles that are missing, up to now.
  void noteDropped(std::uint64_t dropped);
  void finish();

  const std::string& folder() const { return folder_; }
  std::uint64_t cycles() const { return cycles_; }

private:
  struct Topic {
    std::string last;
  };
  struct Thread {
    std::vector<Topic> topics;
    std::uint64_t sinceComplete = completeEvery;
  };
  struct Finished {
    std::string name;
    std::uint64_t messages;
    std::int64_t first, last;
    std::vector<std::vector<std::uint64_t>> messagesOf;
  };

  void openFile();
  void closeFile();
  void writeMetadata() const;
  Finished current() const;

  std::string folder_, name_;
  LogWriterOptions options_;
  std::vector<RecordedThread> threads_;
  std::vector<Thread> states_;
  std::unique_ptr<BagFile> file_;
  std::size_t nextFile_ = 0;
  std::vector<Finished> finished_;
  std::uint64_t cycles_ = 0, dropped_ = 0;
};

}  // namespace plumbline::record
