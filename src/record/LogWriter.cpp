#include "record/LogWriter.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "framework/WriteFile.h"
#include "record/RosMessage.h"

namespace plumbline::record {

namespace fs = std::filesystem;

LogWriter::LogWriter(const std::string& folder, LogWriterOptions options)
    : folder_(folder), options_(options) {
  fs::path path = fs::path(folder).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  name_ = path.filename().string();
  if (name_.empty() || name_ == "." || name_ == "..")
    throw std::runtime_error(folder + ": a log needs a name of its own");
  folder_ = path.string();
  std::error_code error;
  if (fs::exists(path, error))
    throw std::runtime_error(folder_ + " exists already: a log is never overwritten; choose another name");
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  if (!error) fs::create_directory(path, error);
  if (error) throw std::runtime_error(folder_ + ": the log's folder cannot be made: " + error.message());
}

LogWriter::~LogWriter() {
  try {
    finish();
  } catch (const std::exception&) {  // the last writer has reported it
  }
  std::error_code error;
  if (nextFile_ == 0) fs::remove(folder_, error);  // nothing was written
}

void LogWriter::begin(std::vector<RecordedThread> threads) {
  threads_ = std::move(threads);
  for (const RecordedThread& thread : threads_) {
    states_.emplace_back();
    states_.back().topics.resize(thread.topics.size());
  }
  openFile();
}

void LogWriter::openFile() {
  // This one counts as well.
  std::error_code error;
  while (options_.files > 0 && finished_.size() >= options_.files) {
    fs::remove(fs::path(folder_) / finished_.front().name, error);
    finished_.erase(finished_.begin());
  }
  const std::string path = (fs::path(folder_) / (name_ + '_' + std::to_string(nextFile_) + ".db3")).string();
  file_ = std::make_unique<BagFile>(path, threads_);
  nextFile_++;
  for (Thread& thread : states_) thread.sinceComplete = completeEvery;
  writeMetadata();
}

LogWriter::Finished LogWriter::current() const {
  return {fs::path(file_->path()).filename().string(), file_->messages(), file_->first(), file_->last(),
          file_->messagesOf()};
}

void LogWriter::closeFile() {
  if (!file_) return;
  file_->note("dropped", std::to_string(dropped_));
  file_->finish();
  finished_.push_back(current());
  file_.reset();
}

void LogWriter::write(const CycleView& cycle) {
  if (file_->size() > options_.fileBytes) {
    closeFile();
    openFile();
  }
  Thread& thread = states_[cycle.thread];
  const bool complete = ++thread.sinceComplete > completeEvery;
  if (complete) thread.sinceComplete = 1;
  file_->beginCycle(cycle.thread, cycle.number, cycle.timestamp, complete);
  for (std::size_t i = 0; i < cycle.messages.size(); ++i) {
    const std::string_view message = cycle.messages[i];
    if (!complete && thread.topics[i].last == message) continue;
    file_->add(cycle.thread, i, message);
    thread.topics[i].last.assign(message);
  }
  cycles_++;
}

void LogWriter::commit() {
  if (file_) file_->commit();
}

void LogWriter::noteDropped(std::uint64_t dropped) {
  dropped_ = dropped;
  if (file_) file_->note("dropped", std::to_string(dropped));
}

void LogWriter::finish() {
  if (!file_) return;
  closeFile();
  writeMetadata();
}

void LogWriter::writeMetadata() const {
  std::vector<Finished> files = finished_;
  if (file_) files.push_back(current());
  std::uint64_t messages = 0;
  std::int64_t first = 0, last = 0;
  bool any = false;
  std::vector<std::vector<std::uint64_t>> counts;
  for (const RecordedThread& thread : threads_) counts.emplace_back(thread.topics.size(), 0);
  std::string paths, entries;
  for (const Finished& file : files) {
    paths += "    - " + file.name + '\n';
    entries += "    - path: " + file.name +
               "\n      starting_time:\n        nanoseconds_since_epoch: " + std::to_string(file.first) +
               "\n      duration:\n        nanoseconds: " + std::to_string(file.last - file.first) +
               "\n      message_count: " + std::to_string(file.messages) + '\n';
    messages += file.messages;
    if (file.messages > 0) {
      first = any ? std::min(first, file.first) : file.first;
      last = any ? std::max(last, file.last) : file.last;
      any = true;
    }
    for (std::size_t t = 0; t < counts.size(); ++t)
      for (std::size_t i = 0; i < counts[t].size(); ++i) counts[t][i] += file.messagesOf[t][i];
  }
  std::string topics;
  for (std::size_t t = 0; t < threads_.size(); ++t) {
    for (std::size_t i = 0; i < threads_[t].topics.size(); ++i) {
      const std::string& name = threads_[t].topics[i].representation;
      topics += "    - topic_metadata:\n        name: /" + threads_[t].name + '/' + name +
                "\n        type: " + messageType(name) +
                "\n        serialization_format: cdr\n        offered_qos_profiles: \"\"\n" +
                "        type_description_hash: \"\"\n      message_count: " + std::to_string(counts[t][i]) +
                '\n';
    }
  }
  writeFile((fs::path(folder_) / "metadata.yaml").string(),
            "rosbag2_bagfile_information:\n  version: 8\n  storage_identifier: sqlite3\n  duration:\n    "
            "nanoseconds: " +
                std::to_string(last - first) +
                "\n  starting_time:\n    nanoseconds_since_epoch: " + std::to_string(first) +
                "\n  message_count: " + std::to_string(messages) + "\n  topics_with_message_count:" +
                (topics.empty() ? " []" : "\n" + topics.substr(0, topics.size() - 1)) +
                "\n  compression_format: \"\"\n  compression_mode: \"\"\n  relative_file_paths:\n" + paths +
                "  files:\n" + entries + "  custom_data:\n    program: plumbline\n  ros_distro: iron\n");
}

}  // namespace plumbline::record
