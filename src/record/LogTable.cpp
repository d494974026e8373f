#include "record/LogTable.h"

#include <algorithm>
#include <map>
#include <ostream>
#include <stdexcept>
#include <unordered_map>

#include "framework/NearestName.h"
#include "framework/StopSignal.h"
#include "record/Fields.h"

namespace plumbline::record {
namespace {

void collect(const Schema& schema, const std::string& path, std::vector<std::string>& paths) {
  if (schema.kind != Schema::Kind::object) {
    paths.push_back(path);  // a list, too: one cell
    return;
  }
  for (std::size_t i = 0; i < schema.parts.size(); ++i) {
    const std::string& label = schema.parts[i].label;
    collect(schema.parts[i], path + (label.empty() ? '[' + std::to_string(i) + ']' : '.' + label), paths);
  }
}

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

bool isBelow(const std::string& name, const std::string& stem) {
  return name.starts_with(stem) &&
         (name.size() == stem.size() || name[stem.size()] == '.' || name[stem.size()] == '[');
}

/// The cells of one topic's columns.
class Cells {
public:
  void add(const std::string& path, std::size_t column) { of_[path] = column; }
  bool empty() const { return of_.empty(); }

  void read(const Schema& schema, const std::string& message, std::vector<std::string>& row) const {
    for (const auto& [path, column] : of_) row[column].clear();
    if (message.empty()) return;
    visitFields(schema, message, [&](const std::string& path, const FieldValue& value) {
      if (const auto found = of_.find(path); found != of_.end()) {
        row[found->second] = fieldText(value);
        return;
      }
      // An element of a list, maybe a part of it: its column is the longest column name that it begins with.
      for (auto end = path.rfind('['); end != std::string::npos && end > 0; end = path.rfind('[', end - 1)) {
        const auto list = of_.find(path.substr(0, end));
        if (list == of_.end()) continue;
        std::string& text = row[list->second];
        text += (text.empty() ? "" : " ") + fieldText(value);
        return;
      }
    });
    for (const auto& [path, column] : of_) row[column] = cell(row[column]);
  }

private:
  std::unordered_map<std::string, std::size_t> of_;
};

}  // namespace

std::vector<LogColumn> logColumns(const LogReader& log, const LogReader::Thread& thread,
                                  const std::vector<std::string>& names) {
  std::vector<LogColumn> columns;
  std::vector<std::string> known;
  std::vector<bool> used(names.size(), false);
  for (std::size_t topic = 0; topic < thread.recorded.topics.size(); ++topic) {
    const RecordedTopic& recorded = thread.recorded.topics[topic];
    known.push_back(recorded.representation);
    std::vector<std::string> paths;
    collect(recorded.schema, "", paths);
    for (const std::string& path : paths) {
      const std::string name = recorded.representation + path;
      known.push_back(name);
      bool wanted = names.empty();
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (!isBelow(name, names[i])) continue;
        wanted = used[i] = true;
      }
      if (wanted) columns.push_back({topic, path, name});
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!used[i]) throw std::runtime_error(log.path() + " has no " + names[i] + suggestion(names[i], known));
  return columns;
}

std::uint64_t writeCsv(LogReader& log, const LogReader::Thread& thread, const std::vector<LogColumn>& columns,
                       const LogPart& part, std::ostream& out, const Progress& progress) {
  std::vector<Cells> cells(thread.recorded.topics.size());
  std::string line = "time,cycle";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    cells[columns[i].topic].add(columns[i].path, i);
    line += ',' + cell(columns[i].name);
  }
  out << line << '\n';
  std::vector<std::string> row(columns.size()), messages(cells.size());
  std::uint64_t lines = 0;
  for (std::size_t c = 0; c < thread.cycles.size(); ++c) {
    StopSignal::throwIfCaught();
    if (progress && c % 256 == 0)
      progress(static_cast<double>(c) / static_cast<double>(thread.cycles.size()));
    const LogReader::Cycle& cycle = thread.cycles[c];
    log.read(thread, cycle, [&](std::size_t topic, std::string_view message) {
      if (cells[topic].empty()) return;
      messages[topic].assign(message);
      cells[topic].read(thread.recorded.topics[topic].schema, messages[topic], row);
    });
    const double time = secondsOf(cycle.timestamp);
    if (time < part.from || time > part.to || cycle.number < part.firstCycle || cycle.number > part.lastCycle)
      continue;
    line = fieldText(time) + ',' + std::to_string(cycle.number);
    for (const std::string& text : row) line += ',' + text;
    out << line << '\n';
    lines++;
  }
  return lines;
}

}  // namespace plumbline::record
