#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "framework/StopSignal.h"
#include "gap/run/OtherTables.h"
#include "gap/run/Run.h"
#include "record/CdrStream.h"
#include "record/Database.h"

namespace plumbline::gap {

namespace {

namespace fs = std::filesystem;
using record::CdrInStream;

constexpr std::size_t mostFiles = 10'000;
constexpr const char* jointState = "sensor_msgs/msg/JointState";

/// The values of a message by column; names without the topic.
using Values = std::vector<std::pair<std::string, double>>;

std::vector<std::string> texts(CdrInStream& in) {
  std::vector<std::string> list;
  in.beginList();
  while (in.nextElement()) in.readString(list.emplace_back());
  in.endList();
  return list;
}

std::vector<double> numbers(CdrInStream& in) {
  std::vector<double> list;
  in.beginList();
  while (in.nextElement()) in.readDouble(list.emplace_back());
  in.endList();
  return list;
}

/// The time that a message's sender gave it, as the column "stamp" [s]; what the network did is not in it.
Values readHeader(CdrInStream& in) {
  std::int64_t seconds = 0;
  std::uint64_t nanoseconds = 0;
  std::string frame;
  in.readSigned(seconds, 4);
  in.readUnsigned(nanoseconds, 4);
  in.readString(frame);
  return {{"stamp", static_cast<double>(seconds) + 1e-9 * static_cast<double>(nanoseconds)}};
}

void add(Values& values, const std::string& field, const std::vector<std::string>& names,
         const std::vector<double>& list) {
  for (std::size_t i = 0; i < std::min(names.size(), list.size()); ++i)
    values.emplace_back(field + "." + names[i], list[i]);
}

Values readJointState(CdrInStream& in) {
  Values values = readHeader(in);
  const std::vector<std::string> names = texts(in);
  for (const char* field : {"position", "velocity", "effort"}) add(values, field, names, numbers(in));
  return values;
}

/// Of its first point.
Values readTrajectory(CdrInStream& in) {
  Values values = readHeader(in);
  const std::vector<std::string> names = texts(in);
  in.beginList();
  for (bool first = true; in.nextElement(); first = false) {
    for (const char* field : {"positions", "velocities", "accelerations", "effort"}) {
      const std::vector<double> list = numbers(in);
      if (first) add(values, field, names, list);
    }
    std::int64_t seconds = 0;
    std::uint64_t nanoseconds = 0;
    in.readSigned(seconds, 4);
    in.readUnsigned(nanoseconds, 4);
  }
  in.endList();
  return values;
}

Values readArray(CdrInStream& in) {
  in.beginList();
  while (in.nextElement()) {
    std::string label;
    std::uint64_t size = 0;
    in.readString(label);
    in.readUnsigned(size, 4);
    in.readUnsigned(size, 4);
  }
  in.endList();
  std::uint64_t offset = 0;
  in.readUnsigned(offset, 4);
  Values values;
  for (const double value : numbers(in)) values.emplace_back("data." + std::to_string(values.size()), value);
  return values;
}

Values readImu(CdrInStream& in) {
  Values values = readHeader(in);
  const auto read = [&](const char* field, std::string_view axes) {
    for (const char axis : axes) {
      double value = 0;
      in.readDouble(value);
      values.emplace_back(std::string(field) + "." + axis, value);
    }
    double covariance = 0;
    for (int i = 0; i < 9; ++i) in.readDouble(covariance);
  };
  read("orientation", "xyzw");
  read("angular_velocity", "xyz");
  read("linear_acceleration", "xyz");
  return values;
}

struct Type {
  const char* name;
  Values (*read)(CdrInStream&);
};
constexpr Type types[] = {{jointState, readJointState},
                          {"trajectory_msgs/msg/JointTrajectory", readTrajectory},
                          {"std_msgs/msg/Float64MultiArray", readArray},
                          {"sensor_msgs/msg/Imu", readImu}};

/// What to do with a bag of another storage.
std::string conversion(const std::string& path) {
  return "of a bag of another storage (.mcap) make one: echo 'output_bags: [{uri: converted, storage_id: "
         "sqlite3, all: true}]' > convert.yaml; ros2 bag convert -i " +
         path + " -o convert.yaml; then import the folder converted";
}

std::vector<std::string> filesOf(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return {path};
  std::vector<std::string> files;
  for (fs::directory_iterator at(path, error), end; !error && at != end; at.increment(error))
    if (at->path().extension() == ".db3" && files.size() < mostFiles) files.push_back(at->path().string());
  if (files.empty()) throw RunError(path + ": holds no .db3 file; " + conversion(path));
  std::ranges::sort(files, {}, [](const std::string& file) { return std::pair(file.size(), file); });
  return files;
}

/// A topic's name as columns begin with it: /imu/data -> imu.data
std::string headOf(std::string_view topic) {
  std::string head(topic.substr(topic.starts_with('/') ? 1 : 0));
  std::ranges::replace(head, '/', '.');
  return head + ".";
}

class Bag {
public:
  explicit Bag(const std::string& path) : path_(path) {}

  Table read() {
    for (const std::string& file : filesOf(path_)) {
      try {
        readFile(file);
      } catch (const RunError&) {
        throw;
      } catch (const std::runtime_error& error) {
        throw RunError(std::string(error.what()) + "; it is no bag of ROS 2");
      }
    }
    if (messages_.empty())
      throw RunError(path_ + ": has no message of " + kinds() +
                     (others_.empty() ? "" : "; it has " + others_));
    std::ranges::stable_sort(messages_, {}, &Message::time);
    return tableOf(leading());
  }

private:
  struct Message {
    std::int64_t time = 0;  ///< [ns]
    std::size_t topic = 0;
    Values values;
  };
  struct Topic {
    std::string name;
    const Type* type = nullptr;
    std::size_t count = 0;
  };

  static std::string kinds() {
    std::string list;
    for (const Type& type : types) list += (list.empty() ? "" : ", ") + std::string(type.name);
    return list;
  }

  void readFile(const std::string& file) {
    record::Database database(file, record::Database::Mode::read);
    std::map<std::int64_t, std::size_t> topicOf;
    record::Statement list(database, "SELECT id, name, type, serialization_format FROM topics ORDER BY id");
    while (list.step()) {
      const std::string name(list.text(1)), typeName(list.text(2));
      const Type* type = nullptr;
      for (const Type& known : types)
        if (typeName == known.name && list.text(3) == "cdr") type = &known;
      if (!type) {
        if (others_.size() < 500) others_ += (others_.empty() ? "" : ", ") + name + " (" + typeName + ")";
        continue;
      }
      const auto known = std::ranges::find(topics_, name, &Topic::name);
      topicOf[list.integer(0)] = static_cast<std::size_t>(known - topics_.begin());
      if (known == topics_.end()) topics_.push_back({name, type});
    }
    record::Statement all(database, "SELECT topic_id, timestamp, data FROM messages ORDER BY id");
    while (all.step()) {
      StopSignal::throwIfCaught();
      const auto topic = topicOf.find(all.integer(0));
      if (topic == topicOf.end()) continue;
      CdrInStream in(all.blob(2));
      Message message{all.integer(1), topic->second, topics_[topic->second].type->read(in)};
      if (!in.ok())
        throw RunError(file + ": a message of " + topics_[topic->second].name + " is damaged: " + in.error());
      ++topics_[topic->second].count;
      cells_ += message.values.size();
      if (cells_ > maxCells)
        throw RunError(path_ + ": more than " + std::to_string(maxCells) +
                       " numbers; cut it into shorter bags");
      messages_.push_back(std::move(message));
    }
  }

  /// The topic whose messages make the lines.
  std::size_t leading() const {
    std::size_t best = topics_.size();
    for (std::size_t i = 0; i < topics_.size(); ++i)
      if (std::string_view(topics_[i].type->name) == jointState &&
          (best == topics_.size() || topics_[i].count > topics_[best].count))
        best = i;
    if (best == topics_.size() || topics_[best].count < 2)
      throw RunError(path_ + ": has no two messages of " + jointState + "; a run needs positions");
    return best;
  }

  Table tableOf(std::size_t lead) const {
    Table table;
    table.names = {"t"};
    std::map<std::string, std::size_t> index;
    for (const Message& message : messages_)
      for (const auto& [name, value] : message.values) {
        const std::string column = headOf(topics_[message.topic].name) + name;
        if (index.try_emplace(column, table.names.size()).second) table.names.push_back(column);
        if (table.names.size() > maxColumns)
          throw RunError(path_ + ": more than " + std::to_string(maxColumns) + " columns");
      }
    if (table.names.size() * topics_[lead].count > maxCells)
      throw RunError(path_ + ": more than " + std::to_string(maxCells) + " cells; cut it into shorter bags");
    table.columns.resize(table.names.size());
    std::vector<double> now(table.names.size(), std::numeric_limits<double>::quiet_NaN());
    std::int64_t begin = 0;
    for (const Message& message : messages_) {
      for (const auto& [name, value] : message.values)
        now[index.at(headOf(topics_[message.topic].name) + name)] = std::isfinite(value) ? value : NAN;
      if (message.topic != lead) continue;
      if (table.columns[0].empty()) begin = message.time;
      now[0] = static_cast<double>(message.time - begin) / 1e9;
      for (std::size_t c = 0; c < now.size(); ++c) table.columns[c].push_back(now[c]);
    }
    return table;
  }

  const std::string path_;
  std::vector<Topic> topics_;
  std::vector<Message> messages_;
  std::size_t cells_ = 0;
  std::string others_;
};

}  // namespace

Table readRosBag(const std::string& path) { return Bag(path).read(); }

Table readRecording(const std::string& path, const TableForm& form) {
  std::string ending = fs::path(path).extension().string();
  if (ending == ".gz") ending = fs::path(path).stem().extension().string();
  std::error_code error;
  if (ending == ".mcap") throw RunError(path + ": is a bag in MCAP, which is not read; " + conversion(path));
  if (ending == ".db3" || fs::is_directory(path, error)) return readRosBag(path);
  if (ending == ".jsonl" || ending == ".ndjson" || ending == ".json") return readJsonLines(path);
  return readTable(path, form);
}

}  // namespace plumbline::gap
