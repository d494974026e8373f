#include "record/BagFile.h"

#include <algorithm>

#include "record/RosMessage.h"

namespace plumbline::record {
namespace {

constexpr std::uint64_t emptySize = 64 << 10, rowSize = 40;  ///< about, with the index [bytes]

// WAL and no waiting for the disk: what is committed survives the end of the process, not that of the
// machine.
constexpr const char* tables =
    "PRAGMA journal_mode=WAL; PRAGMA synchronous=OFF;"
    "BEGIN;"
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
    "INSERT INTO schema VALUES(4, 'iron');"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT "
    "NULL);"
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL, type_description_hash TEXT NOT "
    "NULL);"
    "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT "
    "NULL,"
    " encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
    " data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
    "CREATE TABLE plumbline_topics(id INTEGER PRIMARY KEY, thread TEXT NOT NULL, representation TEXT NOT "
    "NULL,"
    " provider TEXT NOT NULL, form TEXT NOT NULL);"
    "CREATE TABLE plumbline_cycles(id INTEGER PRIMARY KEY, thread TEXT NOT NULL, number INTEGER NOT NULL,"
    " timestamp INTEGER NOT NULL, first_message INTEGER NOT NULL, complete INTEGER NOT NULL);"
    "CREATE TABLE plumbline_log(key TEXT PRIMARY KEY, value TEXT NOT NULL);";

}  // namespace

BagFile::Tables::Tables(Database& database) { database.run(tables); }

BagFile::BagFile(const std::string& path, const std::vector<RecordedThread>& threads)
    : database_(path, Database::Mode::create),
      open_(true),
      size_(emptySize),
      tables_(database_),
      message_(database_, "INSERT INTO messages VALUES(?, ?, ?, ?)"),
      cycle_(database_, "INSERT INTO plumbline_cycles VALUES(NULL, ?, ?, ?, ?, ?)"),
      note_(database_, "INSERT OR REPLACE INTO plumbline_log VALUES(?, ?)") {
  note("format", std::to_string(formatVersion));
  Statement topic(database_, "INSERT INTO topics VALUES(?, ?, ?, 'cdr', '', '')");
  Statement own(database_, "INSERT INTO plumbline_topics VALUES(?, ?, ?, ?, ?)");
  Statement definition(database_, "INSERT INTO message_definitions VALUES(NULL, ?, 'ros2msg', ?, '')");
  std::vector<std::string> defined;
  std::int64_t id = 1;
  for (std::size_t t = 0; t < threads.size(); ++t) {
    const RecordedThread& thread = threads[t];
    std::string steps;
    for (const std::string& step : thread.steps) steps += step + '\n';
    note("thread " + std::to_string(t), thread.name);
    note("steps " + thread.name, steps);
    firstTopic_.push_back(id);
    counts_.emplace_back(thread.topics.size(), 0);
    for (const RecordedTopic& part : thread.topics) {
      const std::string type = messageType(part.representation);
      topic.with(id, '/' + thread.name + '/' + part.representation, type).run();
      own.with(id, thread.name, part.representation, part.provider, schemaText(part.schema)).run();
      id++;
      if (std::ranges::find(defined, type) != defined.end()) continue;
      defined.push_back(type);
      definition.with(type, messageDefinition(part.representation, part.schema)).run();
    }
  }
  threads_.reserve(threads.size());
  for (const RecordedThread& thread : threads) threads_.push_back(thread.name);
  commit();
}

void BagFile::begin() {
  if (open_) return;
  database_.run("BEGIN");
  open_ = true;
}

void BagFile::beginCycle(std::size_t thread, std::uint64_t number, std::int64_t timestamp, bool complete) {
  begin();
  timestamp_ = timestamp;
  first_ = any_ ? std::min(first_, timestamp) : timestamp;
  last_ = any_ ? std::max(last_, timestamp) : timestamp;
  any_ = true;
  cycle_
      .with(threads_[thread], static_cast<std::int64_t>(number), timestamp, messages_ + 1,
            std::int64_t{complete ? 1 : 0})
      .run();
  size_ += rowSize;
}

void BagFile::add(std::size_t thread, std::size_t topic, std::string_view message) {
  const std::int64_t id = firstTopic_[thread] + static_cast<std::int64_t>(topic);
  message_.with(++messages_, id, timestamp_, Statement::bytes(message)).run();
  counts_[thread][topic]++;
  size_ += message.size() + rowSize;
}

void BagFile::note(std::string_view key, std::string_view value) {
  begin();
  note_.with(key, value).run();
}

void BagFile::commit() {
  if (!open_) return;
  open_ = false;
  database_.run("COMMIT");
}

void BagFile::finish() {
  commit();
  database_.run("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode=DELETE;");
}

}  // namespace plumbline::record
