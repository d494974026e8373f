#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "record/Database.h"
#include "record/RecordedThread.h"

namespace plumbline::record {

/// One file of a log while it is written: an SQLite file in the schema of rosbag2 (version 4), which ROS 2's
/// tools read. It has three additional tables: the cycles, the meaning of each topic, and properties of the
/// log. A writer that is killed loses only what was not committed.
class BagFile {
public:
  static constexpr std::int64_t formatVersion = 1;

  BagFile(const std::string& path, const std::vector<RecordedThread>& threads);

  /// The messages that follow are of this cycle. `complete`: a message of every topic of the thread follows.
  void beginCycle(std::size_t thread, std::uint64_t number, std::int64_t timestamp, bool complete);
  void add(std::size_t thread, std::size_t topic, std::string_view message);

  void commit();
  /// Stores a property of the log, for example the number of missing cycles.
  void note(std::string_view key, std::string_view value);
  /// Commits, and leaves one file alone.
  void finish();

  const std::string& path() const { return database_.path(); }
  /// About how large the file is [bytes].
  std::uint64_t size() const { return size_; }
  std::uint64_t messages() const { return static_cast<std::uint64_t>(messages_); }
  /// Of each thread's topics.
  const std::vector<std::vector<std::uint64_t>>& messagesOf() const { return counts_; }
  std::int64_t first() const { return first_; }
  std::int64_t last() const { return last_; }

private:
  void begin();

  Database database_;
  std::vector<std::string> threads_;
  std::vector<std::int64_t> firstTopic_;  ///< id of each thread's first topic
  std::vector<std::vector<std::uint64_t>> counts_;
  bool open_ = false;  ///< a transaction
  std::int64_t messages_ = 0, timestamp_ = 0, first_ = 0, last_ = 0;
  bool any_ = false;
  std::uint64_t size_ = 0;
  struct Tables {
    explicit Tables(Database& database);
  } tables_;
  Statement message_, cycle_, note_;
};

}  // namespace plumbline::record
