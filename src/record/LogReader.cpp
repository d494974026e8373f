#include "record/LogReader.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "framework/NearestName.h"
#include "record/BagFile.h"

namespace plumbline::record {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxFiles = 100'000;

/// The number of NAME_12.db3; -1: it has none.
long numberOf(const fs::path& path) {
  const std::string stem = path.stem().string();
  const auto bar = stem.rfind('_');
  long number = -1;
  if (bar == std::string::npos) return number;
  const char* end = stem.data() + stem.size();
  const auto read = std::from_chars(stem.data() + bar + 1, end, number);
  return read.ec == std::errc{} && read.ptr == end ? number : -1;
}

std::vector<std::string> filesOf(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw std::runtime_error(path + ": there is no such log");
  if (!fs::is_directory(path, error)) return {path};
  std::vector<fs::path> found;
  for (fs::directory_iterator at(path, error), end; !error && at != end; at.increment(error))
    if (at->path().extension() == ".db3" && found.size() < maxFiles) found.push_back(at->path());
  std::ranges::sort(found, [](const fs::path& a, const fs::path& b) {
    return std::pair(numberOf(a), a.string()) < std::pair(numberOf(b), b.string());
  });
  std::vector<std::string> paths;
  for (const fs::path& file : found) paths.push_back(file.string());
  if (paths.empty()) throw std::runtime_error(path + " is no log: no file NAME_0.db3 is in it");
  return paths;
}

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::string noted(Database& database, const std::string& key) {
  Statement note(database, "SELECT value FROM plumbline_log WHERE key = ?");
  return note.with(std::string_view(key)).step() ? std::string(note.text(0)) : std::string();
}

}  // namespace

std::uint64_t LogReader::Thread::missing() const {
  if (cycles.empty()) return 0;
  const std::uint64_t span = cycles.back().number - cycles.front().number + 1;
  return span > cycles.size() ? span - cycles.size() : 0;
}

LogReader::LogReader(const std::string& path) : path_(path) {
  for (const std::string& file : filesOf(path)) open(file);
  for (Thread& thread : threads_) {
    // Files of several recordings, one after the other, would look like one.
    for (std::size_t i = 1; i < thread.cycles.size(); ++i)
      if (thread.cycles[i].number <= thread.cycles[i - 1].number)
        throw std::runtime_error(path_ + ": cycle " + std::to_string(thread.cycles[i].number) +
                                 " comes behind cycle " + std::to_string(thread.cycles[i - 1].number));
  }
}

void LogReader::open(const std::string& path) {
  File file;
  file.database = std::make_unique<Database>(path, Database::Mode::read);
  bool ours = false;
  try {
    Statement table(*file.database, "SELECT count(*) FROM sqlite_master WHERE name = 'plumbline_cycles'");
    ours = table.step() && table.integer(0) == 1;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(error.what()) + "; it is no log");
  }
  if (!ours) throw std::runtime_error(path + " is no log of this program: it has no table plumbline_cycles");
  if (const std::string format = noted(*file.database, "format");
      format != std::to_string(BagFile::formatVersion))
    throw std::runtime_error(path + " is a log of format " + format + "; this program reads format " +
                             std::to_string(BagFile::formatVersion));
  readThreads(file);
  readCycles(file, static_cast<std::uint32_t>(files_.size()));
  const std::string dropped = noted(*file.database, "dropped");
  std::uint64_t count = 0;
  std::from_chars(dropped.data(), dropped.data() + dropped.size(), count);
  dropped_ = std::max(dropped_, count);
  file.messages = std::make_unique<Statement>(*file.database,
                                              "SELECT topic_id, data FROM messages WHERE id >= ? AND id < ?");
  files_.push_back(std::move(file));
  paths_.push_back(path);
}

void LogReader::readThreads(File& file) {
  const auto indexOf = [&](const std::string& name) {
    const auto found = std::ranges::find(threads_, name, [](const Thread& t) { return t.recorded.name; });
    if (found != threads_.end()) return static_cast<std::size_t>(found - threads_.begin());
    threads_.push_back({{name, linesOf(noted(*file.database, "steps " + name)), {}}, {}});
    return threads_.size() - 1;
  };
  Statement topics(*file.database,
                   "SELECT id, thread, representation, provider, form FROM plumbline_topics ORDER BY id");
  while (topics.step()) {
    const std::string representation(topics.text(2));
    RecordedTopic topic{representation, std::string(topics.text(3)), {}};
    try {
      topic.schema = schemaFromText(topics.text(4));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(file.database->path() + ": " + representation + ": " + error.what());
    }
    const std::size_t thread = indexOf(std::string(topics.text(1)));
    auto& known = threads_[thread].recorded.topics;
    const auto found = std::ranges::find(known, representation, &RecordedTopic::representation);
    if (found != known.end() && found->schema != topic.schema)
      throw std::runtime_error(file.database->path() + ": " + representation +
                               " has other members than in the files before");
    file.topics[topics.integer(0)] = {thread, static_cast<std::size_t>(found - known.begin())};
    if (found == known.end()) known.push_back(std::move(topic));
  }
  if (threads_.empty()) throw std::runtime_error(file.database->path() + " is a log of nothing");
}

void LogReader::readCycles(File& file, std::uint32_t index) {
  Statement all(*file.database, "SELECT coalesce(max(id), 0) FROM messages");
  const std::int64_t end = all.step() ? all.integer(0) + 1 : 1;
  Statement cycles(
      *file.database,
      "SELECT thread, number, timestamp, first_message, complete FROM plumbline_cycles ORDER BY id");
  std::pair<std::size_t, std::size_t> before{threads_.size(), 0};
  while (cycles.step()) {
    const std::string name(cycles.text(0));
    const auto found = std::ranges::find(threads_, name, [](const Thread& t) { return t.recorded.name; });
    if (found == threads_.end()) continue;
    const std::int64_t first = cycles.integer(3);
    if (before.first < threads_.size()) threads_[before.first].cycles[before.second].end = first;
    before = {static_cast<std::size_t>(found - threads_.begin()), found->cycles.size()};
    found->cycles.push_back({static_cast<std::uint64_t>(cycles.integer(1)), cycles.integer(2), first, end,
                             index, cycles.integer(4) == 1});
  }
}

const LogReader::Thread& LogReader::thread(const std::string& name) const {
  if (name.empty() && threads_.size() == 1) return threads_.front();
  std::vector<std::string> names;
  for (const Thread& thread : threads_) {
    if (thread.recorded.name == name) return thread;
    names.push_back(thread.recorded.name);
  }
  std::string known;
  for (const std::string& other : names) known += (known.empty() ? "" : ", ") + other;
  throw std::runtime_error(path_ + (name.empty() ? ": say which thread" : " has no thread " + name) +
                           "; it has " + known);
}

void LogReader::read(const Thread& thread, const Cycle& cycle, const Visitor& visitor) {
  File& file = files_[cycle.file];
  const auto index = static_cast<std::size_t>(&thread - threads_.data());
  file.messages->with(cycle.first, cycle.end);
  while (file.messages->step()) {
    const auto topic = file.topics.find(file.messages->integer(0));
    if (topic == file.topics.end() || topic->second.first != index) continue;
    visitor(topic->second.second, file.messages->blob(1));
  }
}

void LogReader::readWhole(const Thread& thread, std::size_t cycle, std::vector<std::string>& messages) {
  messages.assign(thread.recorded.topics.size(), {});
  std::size_t from = cycle;
  while (from > 0 && !thread.cycles[from].complete) from--;
  for (; from <= cycle; ++from)
    read(thread, thread.cycles[from],
         [&](std::size_t topic, std::string_view message) { messages[topic].assign(message); });
}

}  // namespace plumbline::record
