#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "record/Database.h"
#include "record/RecordedThread.h"

namespace plumbline::record {

/// Of a time stamp [s].
inline double secondsOf(std::int64_t timestamp) { return static_cast<double>(timestamp) / 1e9; }

/// Reads a log. A message is in it only if it changed; the reader knows which cycle has which messages.
class LogReader {
public:
  struct Cycle {
    std::uint64_t number;     ///< as the recorder counted, from 1; a gap: cycles that were dropped
    std::int64_t timestamp;   ///< [ns]
    std::int64_t first, end;  ///< ids of its messages
    std::uint32_t file;
    bool complete;  ///< has a message of every topic
  };
  struct Thread {
    RecordedThread recorded;
    std::vector<Cycle> cycles;
    std::uint64_t missing() const;  ///< cycles within the recording
  };

  /// A log's folder, or one of its files. Throws std::runtime_error, one line, for anything else.
  explicit LogReader(const std::string& path);

  const std::string& path() const { return path_; }
  const std::vector<Thread>& threads() const { return threads_; }
  /// By name. Throws std::runtime_error that names the threads there are; an empty name: the only one.
  const Thread& thread(const std::string& name) const;
  /// Cycles that the recorder dropped.
  std::uint64_t dropped() const { return dropped_; }
  const std::vector<std::string>& files() const { return paths_; }

  /// The messages of a cycle; the topic is an index of the thread's. Valid until the next call.
  using Visitor = std::function<void(std::size_t topic, std::string_view message)>;
  void read(const Thread& thread, const Cycle& cycle, const Visitor& visitor);
  /// All topics' messages as they were in that cycle (an index), changed in it or before.
  void readWhole(const Thread& thread, std::size_t cycle, std::vector<std::string>& messages);

private:
  struct File {
    std::unique_ptr<Database> database;
    std::unique_ptr<Statement> messages;
    std::map<std::int64_t, std::pair<std::size_t, std::size_t>> topics;  ///< thread and topic by id
  };

  void open(const std::string& path);
  void readThreads(File& file);
  void readCycles(File& file, std::uint32_t index);

  std::string path_;
  std::vector<std::string> paths_;
  std::vector<File> files_;
  std::vector<Thread> threads_;
  std::uint64_t dropped_ = 0;
};

}  // namespace plumbline::record
