#include "gap/run/OtherTables.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "gap/run/Run.h"
#include "gap/run/RunImport.h"
#include "record/CdrStream.h"
#include "record/Database.h"

namespace plumbline::gap {
namespace {

namespace fs = std::filesystem;
using record::CdrOutStream;
using record::Statement;

class OtherTables : public testing::Test {
protected:
  OtherTables() : folder((fs::path(testing::TempDir()) / ("tables" + std::to_string(getpid()))).string()) {
    fs::create_directories(folder);
  }
  ~OtherTables() override { fs::remove_all(folder); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder + "/" + name) << text;
    return folder + "/" + name;
  }
  std::string errorOf(const std::string& path) const {
    try {
      readRecording(path, {});
      return "no error";
    } catch (const RunError& error) {
      std::string what = error.what();
      for (std::size_t at; (at = what.find(folder)) != std::string::npos;) what.erase(at, folder.size() + 1);
      return what;
    }
  }
  static const std::vector<double>& column(const Table& table, const std::string& name) {
    const auto at = std::ranges::find(table.names, name);
    if (at == table.names.end()) throw std::out_of_range(name);
    return table.columns[static_cast<std::size_t>(at - table.names.begin())];
  }

  const std::string folder;
};

TEST_F(OtherTables, jsonLinesByTheirPaths) {
  const Table table = readRecording(write("log.jsonl",
                                          "{\"t\": 0, \"imu\": {\"gyro\": [0.1, 0.2]}, \"on\": true}\n\n"
                                          "{\"t\": 0.01, \"imu\": {\"gyro\": [0.3, null]}, \"late\": 5}\n"),
                                    {});
  EXPECT_EQ(column(table, "t"), (std::vector{0.0, 0.01}));
  EXPECT_EQ(column(table, "imu.gyro.0"), (std::vector{0.1, 0.3}));
  EXPECT_EQ(column(table, "imu.gyro.1")[0], 0.2);
  EXPECT_TRUE(std::isnan(column(table, "imu.gyro.1")[1]));
  EXPECT_EQ(column(table, "on")[0], 1);
  EXPECT_TRUE(std::isnan(column(table, "late")[0]));
  EXPECT_EQ(column(table, "late")[1], 5);
}

TEST_F(OtherTables, listsWithNamesInTheSameTable) {
  const std::string line =
      R"({"t": 0, "state": {"name": ["a", "b"], "position": [1, 2], "more": [1, 2, 3]}})";
  const Table table = readRecording(write("log.ndjson", line + "\n" + line + "\n"), {});
  EXPECT_EQ(column(table, "state.position.b"), (std::vector{2.0, 2.0}));
  EXPECT_EQ(column(table, "state.more.2"), (std::vector{3.0, 3.0}));
}

TEST_F(OtherTables, aListOfObjectsIsReadAsJsonLinesAre) {
  for (const std::string text :
       {R"([{"t": 0, "q": "]}{["}, {"t": 0.01, "q": {"a": 5}}])",
        "\xef\xbb\xbf[\n  {\n \"t\": 0, \"q\": \"\\\"}\"\n},\n{\"t\": 0.01,\n\"q\": {\"a\": 5}}\n]\n"}) {
    const Table table = readRecording(write("log.json", text), {});
    EXPECT_EQ(column(table, "t"), (std::vector{0.0, 0.01}));
    EXPECT_EQ(column(table, "q.a")[1], 5);
  }
  std::string longList = "[";
  for (int i = 0; i < 20000; ++i)
    longList += (i ? ", " : "") + std::string("{\"t\": ") + std::to_string(i) + "}";
  EXPECT_EQ(column(readRecording(write("log.json", longList + "]"), {}), "t").size(), 20000U)
      << "in one line";
  const std::string line = "{\"t\": 0}\n{\"t\": 1}\n";
  EXPECT_EQ(column(readRecording(write("log.json", line), {}), "t").size(), 2U) << "lines of that ending";
}

TEST_F(OtherTables, whatIsNoListOfObjectsIsNamedWithItsLine) {
  EXPECT_EQ(errorOf(write("a.json", "[{\"t\": 0},\n[1]]")),
            "a.json:2: is no object; each entry is one: {\"t\": 0.01, ...}");
  EXPECT_EQ(errorOf(write("a.json", "[{\"t\": 0},\n{\"t\": }]")), "a.json:2: broken JSON");
  EXPECT_EQ(errorOf(write("a.json", "[{\"t\": 0}\n{\"t\": 1}]")),
            "a.json:1: broken JSON: a comma or ] is missing behind an entry");
  EXPECT_EQ(errorOf(write("a.json", "[{\"t\": 0},\n{\"t\": 1")),
            "a.json:2: the file is cut short: its list does not end");
  EXPECT_EQ(errorOf(write("a.json", "[{\"t\": 0}, {\"t\": 1}]\n[]")),
            "a.json:1: goes on behind its list; give one list of objects");
  EXPECT_EQ(errorOf(write("a.json", "[{\"t\": 0}]")),
            "a.json: has 1 entries of data; a run needs two at least");
  EXPECT_EQ(errorOf(write("a.json", "[{\"t\": \"" + std::string(200000, 'x') + "\"}]")),
            "a.json:1: the entry is longer than 131072 characters");
}

TEST_F(OtherTables, aBagInMcapIsAnErrorThatSaysWhatToDo) {
  const std::string make =
      "echo 'output_bags: [{uri: converted, storage_id: sqlite3, all: true}]' > convert.yaml; ros2 bag "
      "convert -i ";
  EXPECT_EQ(errorOf(write("a.mcap", "MCAP")),
            "a.mcap: is a bag in MCAP, which is not read; of a bag of another storage (.mcap) make one: " +
                make + "a.mcap -o convert.yaml; then import the folder converted");
  fs::create_directories(folder + "/bag");
  write("bag/a.mcap", "MCAP");
  EXPECT_EQ(errorOf(folder + "/bag"),
            "bag: holds no .db3 file; of a bag of another storage (.mcap) make one: " + make +
                "bag -o convert.yaml; then import the folder converted");
}

TEST_F(OtherTables, whatIsNoJsonIsNamedWithItsLine) {
  EXPECT_EQ(errorOf(write("a.jsonl", "{\"t\": 0}\n[1]\n")),
            "a.jsonl:2: is no object; each line is one: {\"t\": 0.01, ...}");
  EXPECT_EQ(errorOf(write("a.jsonl", "{\"t\": 0}\n{\"t\": \n")), "a.jsonl:2: broken JSON");
  EXPECT_EQ(errorOf(write("a.jsonl", "{\"t\": 0}\n")),
            "a.jsonl: has 1 lines of data; a run needs two at least");
  const Table words = readRecording(write("a.jsonl", "{\"t\": \"x\"}\n{\"t\": 1}\n"), {});
  EXPECT_EQ(words.bad.at("t").line, 1U);
}

/// A bag in the schema of rosbag2's SQLite storage.
class Bag {
public:
  explicit Bag(const std::string& path) : database(path, record::Database::Mode::create) {
    database.run(
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT "
        "NULL, "
        "data BLOB NOT NULL);");
  }
  void topic(std::int64_t id, std::string_view name, std::string_view type) {
    Statement(database, "INSERT INTO topics VALUES(?, ?, ?, 'cdr', '')").with(id, name, type).run();
  }
  void message(std::int64_t topic, std::int64_t time, const CdrOutStream& out) {
    Statement(database, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)")
        .with(topic, time, Statement::bytes(out.bytes()))
        .run();
  }

  record::Database database;
};

void header(CdrOutStream& out, std::uint32_t nanoseconds) {
  out.begin();
  out.writeSigned(7, 4);
  out.writeUnsigned(nanoseconds, 4);
  out.writeString("base");
}

void numbers(CdrOutStream& out, const std::vector<double>& values) {
  out.beginList(values.size(), true);
  for (const double value : values) out.writeDouble(value);
}

CdrOutStream jointState(const std::vector<double>& positions, std::uint32_t nanoseconds = 8) {
  CdrOutStream out;
  header(out, nanoseconds);
  out.beginList(2, true);
  out.writeString("knee");
  out.writeString("hip");
  numbers(out, positions);
  numbers(out, {});
  numbers(out, {0.5, 0.6});
  return out;
}

CdrOutStream array(const std::vector<double>& values) {
  CdrOutStream out;
  out.begin();
  out.beginList(0, true);
  out.writeUnsigned(0, 4);
  numbers(out, values);
  return out;
}

TEST_F(OtherTables, aBagsJointStatesWithTheCommandsSaidLast) {
  const std::string place = folder + "/bag";
  fs::create_directories(place);
  {
    Bag bag(place + "/bag_0.db3");
    bag.topic(1, "/joint_states", "sensor_msgs/msg/JointState");
    bag.topic(2, "/leg/commands", "std_msgs/msg/Float64MultiArray");
    bag.topic(3, "/rosout", "rcl_interfaces/msg/Log");
    bag.message(1, 5'000'000'000, jointState({0.1, 0.2}, 0));
    bag.message(2, 5'004'000'000, array({0.9, 0.8}));
    bag.message(1, 5'010'000'000, jointState({0.3, 0.4}, 250'000'000));
    bag.message(1, 5'020'000'000, jointState({0.5, 0.6}, 500'000'000));
  }
  const Table table = readRecording(place, {});
  EXPECT_EQ(column(table, "t"), (std::vector{0.0, 0.01, 0.02}));
  EXPECT_EQ(column(table, "joint_states.stamp"), (std::vector{7.0, 7.25, 7.5})) << "its sender's time";
  EXPECT_EQ(column(table, "joint_states.position.hip"), (std::vector{0.2, 0.4, 0.6}));
  EXPECT_EQ(column(table, "joint_states.effort.knee"), (std::vector{0.5, 0.5, 0.5}));
  EXPECT_TRUE(std::isnan(column(table, "leg.commands.data.0")[0]));
  EXPECT_EQ(column(table, "leg.commands.data.1")[1], 0.8);
  EXPECT_EQ(column(table, "leg.commands.data.1")[2], 0.8);

  const std::string map = write("map.yaml",
                                "robot: r\nbase: fixed\nmotion: m\nhold: linear\ntime: {from: t}\ncolumns:\n"
                                "  - {to: \"pos.*\", from: \"joint_states.position.*\"}\n"
                                "  - {to: cmd.knee, from: leg.commands.data.0}\n");
  const ImportedRun imported = importRecording(map, place);
  EXPECT_EQ(imported.run.channels.at("pos.knee"), (std::vector{0.1, 0.3, 0.5}));
  EXPECT_EQ(imported.run.channels.at("cmd.knee")[2], 0.9);
  EXPECT_TRUE(imported.run.linearCommands);
}

TEST_F(OtherTables, aBagWithoutJointStatesSaysWhatItHas) {
  {
    Bag bag(folder + "/b.db3");
    bag.topic(1, "/rosout", "rcl_interfaces/msg/Log");
  }
  EXPECT_EQ(errorOf(folder + "/b.db3"),
            "b.db3: has no message of sensor_msgs/msg/JointState, trajectory_msgs/msg/JointTrajectory, "
            "std_msgs/msg/Float64MultiArray, sensor_msgs/msg/Imu; it has /rosout (rcl_interfaces/msg/Log)");
  {
    Bag bag(folder + "/c.db3");
    bag.topic(1, "/joint_states", "sensor_msgs/msg/JointState");
    CdrOutStream cut;
    header(cut, 8);
    bag.message(1, 1, cut);
  }
  EXPECT_EQ(errorOf(folder + "/c.db3"),
            "c.db3: a message of /joint_states is damaged: byte 21: 4 bytes needed, 0 left");
  fs::create_directories(folder + "/empty");
  EXPECT_EQ(errorOf(folder + "/empty").substr(0, 29), "empty: holds no .db3 file; of");
}

}  // namespace
}  // namespace plumbline::gap
