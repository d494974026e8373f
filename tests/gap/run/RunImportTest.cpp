#include "gap/run/RunImport.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace plumbline::gap {
namespace {

using Recording = Run;  // gtest has a Run of its own in test classes

namespace fs = std::filesystem;

constexpr const char* map = R"(robot: nao_v5
base: fixed
motion: "knee bends"
separator: ";"
missing: [x]
time: {from: stamp, unit: us}
rename: {LKneePitch: l_knee}
timing: {pos_at_s: 0.004}
servo:
  LKneePitch: {kp: 30}
columns:
  - {to: "cmd.*", from: "goal_*", unit: deg}
  - {to: pos.LKneePitch, from: angle, counts_per_turn: 4096, sign: -1, offset: 0.5}
  - {to: acc.z, from: az, unit: g}
)";
constexpr const char* recording =
    "stamp;goal_l_knee;goal_HeadYaw;angle;az;other\n"
    "5000000;90;0;0;1;7\n"
    ";90;0;0;1;7\n"
    "5010000;45;x;1024;1;7\n"
    "5020000;0;-90;-1024;0.5;7\n";

class RunImport : public testing::Test {
protected:
  RunImport() : folder((fs::path(testing::TempDir()) / ("import" + std::to_string(getpid()))).string()) {
    fs::create_directories(folder);
  }
  ~RunImport() override { fs::remove_all(folder); }

  ImportedRun import(const std::string& mapText, const std::string& csv) const {
    std::ofstream(folder + "/map.yaml") << mapText;
    std::ofstream(folder + "/raw.csv") << csv;
    return importRecording(folder + "/map.yaml", folder + "/raw.csv");
  }

  /// What an import of several recordings gives: their names in the folder, and their texts.
  ImportedRun importAll(const std::string& mapText,
                        const std::vector<std::pair<std::string, std::string>>& files,
                        const std::string& robot = "") const {
    std::ofstream(folder + "/map.yaml") << mapText;
    ImportOptions options{folder + "/map.yaml", {}, robot};
    for (const auto& [name, text] : files) {
      std::ofstream(folder + "/" + name) << text;
      options.recordings.push_back(folder + "/" + name);
    }
    return importRecordings(options);
  }
  std::string refused(const std::string& mapText,
                      const std::vector<std::pair<std::string, std::string>>& files) const {
    try {
      importAll(mapText, files);
      return "no error";
    } catch (const ConfigurationError& error) {
      return withoutFolder(error.what());
    }
  }
  std::string withoutFolder(std::string what) const {
    for (std::size_t at; (at = what.find(folder)) != std::string::npos;) what.erase(at, folder.size() + 1);
    return what;
  }

  std::string errorOf(const std::string& from, const std::string& to, std::string csv = recording) const {
    std::string text = map;
    text.replace(text.find(from), from.size(), to);
    try {
      import(text, csv);
      return "no error";
    } catch (const ConfigurationError& error) {
      return withoutFolder(error.what());
    }
  }

  const std::string folder;
};

TEST_F(RunImport, unitsSignsNamesAndTimes) {
  const ImportedRun imported = import(map, recording);
  const Recording& run = imported.run;
  EXPECT_EQ(run.t, (std::vector<double>{0, 0.01, 0.02}));
  EXPECT_EQ(run.rateHz, 100);
  EXPECT_EQ(run.robot, "nao_v5");
  EXPECT_FALSE(run.freeBase);
  EXPECT_EQ(run.timingOf("any").posAt, 0.004);
  EXPECT_EQ(run.servo.at("LKneePitch").kp, 30);
  EXPECT_NEAR((*run.find("cmd.LKneePitch"))[0], M_PI / 2, 1e-15);
  EXPECT_NEAR((*run.find("cmd.HeadYaw"))[2], -M_PI / 2, 1e-15);
  EXPECT_TRUE(std::isnan((*run.find("cmd.HeadYaw"))[1]));
  EXPECT_NEAR((*run.find("pos.LKneePitch"))[1], 0.5 - M_PI / 2, 1e-15);
  EXPECT_NEAR((*run.find("acc.z"))[2], 9.80665 / 2, 1e-15);
  EXPECT_EQ(imported.unused, std::vector<std::string>{"other"});
  EXPECT_EQ(imported.linesWithoutTime, 1u);
}

TEST_F(RunImport, badMapsAreNamed) {
  EXPECT_EQ(errorOf("unit: deg", "unit: grad").substr(0, 42), "map.yaml:12: columns[0].unit is \"grad\"; kn");
  EXPECT_EQ(
      errorOf("from: angle", "from: angel"),
      "map.yaml:13: columns[1].from is \"angel\", which raw.csv has no column of; did you mean \"angle\"?");
  EXPECT_EQ(errorOf("goal_*", "target_*"),
            "map.yaml:12: columns[0].from is \"target_*\", which no column of raw.csv fits");
  EXPECT_EQ(errorOf("\"cmd.*\"", "cmd.X"), "map.yaml:12: columns[0].from needs as many * as to, one at most");
  EXPECT_EQ(errorOf("to: acc.z", "to: acc.up"),
            "map.yaml:14: columns[2].to is \"acc.up\"; give a channel such as pos.LKneePitch");
  EXPECT_EQ(errorOf("to: acc.z", "to: cmd.HeadYaw"),
            "map.yaml:14: columns[2].to gives cmd.HeadYaw a second time");
  EXPECT_EQ(errorOf("base: fixed", "base: hung"), "map.yaml:2: base must be fixed or free, not \"hung\"");
  EXPECT_EQ(errorOf("sign: -1", "sgn: -1"),
            "map.yaml:13: unknown key \"columns[1].sgn\"; did you mean \"sign\"?");
  EXPECT_EQ(errorOf("\";\"", "\";;\""), "map.yaml:4: separator is \";;\"; give one character or tab");
}

TEST_F(RunImport, badRecordingsAreNamed) {
  EXPECT_EQ(errorOf("[x]", "[y]"),
            "raw.csv:4: column goal_HeadYaw holds \"x\", no number; words for lost samples go under missing "
            "in the map");
  EXPECT_EQ(errorOf("robot", "robot", "stamp;goal_a;angle;az\n2;1;1;1\n1;1;1;1\n"),
            "raw.csv: row 2 of data: stamp does not grow; sort the recording, or cut it there");
  EXPECT_EQ(errorOf("robot", "robot", "stamp;goal_a;angle;az\n2;1;1;1\n;1;1;1\n"),
            "raw.csv: column stamp holds fewer than two times");
  EXPECT_EQ(errorOf("robot", "robot", ""), "raw.csv: is empty; the first line names the columns");
}

const std::string twoMaps = R"(robot: nao_v5
base: fixed
motion: sweep
tables:
  - time: {from: sent, unit: ms}
    columns: [{to: "cmd.*", from: "goal_*", unit: deg}]
  - time: {from: stamp, unit: us, offset: 0.5}
    separator: ";"
    columns: [{to: "pos.*", from: "angle_*", unit: rad}]
)";
constexpr const char* sent = "sent,goal_HeadYaw\n1500,90\n1510,45\n1520,0\n1530,-45\n";
constexpr const char* taken = "stamp;angle_HeadYaw\n1000000;0\n1010000;0.1\n1020000;0.2\n";

TEST_F(RunImport, twoRecordingsBecomeOne) {
  const ImportedRun imported = importAll(twoMaps, {{"a.csv", sent}, {"b.csv", taken}});
  EXPECT_EQ(imported.run.size(), 3u);
  EXPECT_NEAR(imported.run.t[2], 0.02, 1e-9);
  EXPECT_EQ(imported.run.t[0], 0);
  EXPECT_EQ(imported.run.rateHz, 100);
  EXPECT_NEAR((*imported.run.find("cmd.HeadYaw"))[1], M_PI / 4, 1e-12);
  EXPECT_EQ((*imported.run.find("pos.HeadYaw"))[2], 0.2);
  ASSERT_EQ(imported.merged.size(), 1u);
  EXPECT_TRUE(imported.guesses.empty());
}

TEST_F(RunImport, aMapOfAnotherNumberOfRecordingsIsRefused) {
  EXPECT_EQ(refused(twoMaps, {{"a.csv", sent}}),
            "map.yaml: tables has 2 entries, but 1 recordings are given; give one for each, in the order of "
            "tables");
  EXPECT_EQ(refused(map, {{"a.csv", sent}, {"b.csv", taken}}),
            "map.yaml: describes one recording, but 2 are given; write tables: with an entry for each, in "
            "their order");
  EXPECT_EQ(
      refused(twoMaps, {{"b.csv", taken}, {"a.csv", sent}}),
      "map.yaml:5: tables[0].time.from is \"sent\", which b.csv has no column of (recordings are in the "
      "order of tables)");
  EXPECT_EQ(refused(twoMaps + "time: {from: t}\n", {{"a.csv", sent}, {"b.csv", taken}}),
            "map.yaml:10: time is not allowed next to tables; move it into an entry of tables");
  std::string twice = twoMaps;
  twice.replace(twice.find("pos.*"), 5, "cmd.*");
  EXPECT_EQ(refused(twice, {{"a.csv", sent}, {"b.csv", taken}}),
            "map.yaml:9: tables[1].columns[0].to gives cmd.HeadYaw a second time");
}

constexpr const char* listMap = R"(robot: nao_v5
base: fixed
motion: sweep
time: {from: t, unit: s}
columns:
  - {to: pos.HeadYaw, from: "q[1]", unit: rad}
  - {to: cmd.HeadYaw, from: goal, unit: rad}
)";

TEST_F(RunImport, oneNumberOfAListIsChosen) {
  const std::vector<std::pair<std::string, std::string>>
      csv = {{"a.csv", "t,q,goal\n0,\"[0, 0.5]\",0\n0.01,\"[0, 0.6]\",0\n"}},
      lines = {{"a.jsonl",
                "{\"t\": 0, \"q\": [0, 0.5], \"goal\": 0}\n{\"t\": 0.01, \"q\": [0, 0.6], \"goal\": 0}\n"}};
  for (const auto& files : {csv, lines}) {
    const ImportedRun imported = importAll(listMap, files);
    EXPECT_EQ(*imported.run.find("pos.HeadYaw"), (std::vector<double>{0.5, 0.6}));
    EXPECT_EQ(imported.unused.size(), 1u);
  }
  EXPECT_EQ(refused(listMap, {{"a.csv", "t,q,goal\n0,\"[0, 0.5]\",\"[1, 2]\"\n1,\"[0, 1]\",\"[1, 2]\"\n"}}),
            "map.yaml:7: columns[1].from is \"goal\", whose cells hold lists of 2; choose one, as goal[0]");
  EXPECT_EQ(
      refused(listMap, {{"a.csv", "t,q,goal\n0,\"[0, 0.5]\",0\n1,\"[0]\",1\n"}}),
      "a.csv:3: column q holds \"[0]\", no list of 2 numbers; words for lost samples go under missing in "
      "the map");
}

TEST_F(RunImport, aStarStandsForThePlaceInAList) {
  const ImportedRun imported = importAll(
      "robot: nao_v5\nbase: fixed\nmotion: m\ntime: {from: t, unit: s}\nrename: {HeadYaw: 0, HeadPitch: 1}\n"
      "columns: [{to: \"pos.*\", from: \"q[*]\", unit: rad}]\n",
      {{"a.csv", "t,q\n0,\"[0.1, 0.5]\"\n0.01,\"[0.2, 0.6]\"\n"}});
  EXPECT_EQ(*imported.run.find("pos.HeadYaw"), (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(*imported.run.find("pos.HeadPitch"), (std::vector<double>{0.5, 0.6}));
}

std::string bareMap(const std::string& time, const std::string& column) {
  return "robot: nao_v5\nbase: fixed\nmotion: m\ntime: {from: t" + time +
         "}\ncolumns:\n  - {to: \"pos.*\", from: \"q_*\"" + column + "}\n";
}

TEST_F(RunImport, aUnitThatIsNotStatedIsGuessedAndSaid) {
  const std::string csv = "t,q_HeadYaw\n1000,0\n1010,45\n1020,90\n";
  const ImportedRun imported = importAll(bareMap("", ""), {{"a.csv", csv}});
  EXPECT_NEAR(imported.run.t[2], 0.02, 1e-9);
  EXPECT_NEAR((*imported.run.find("pos.HeadYaw"))[1], M_PI / 4, 1e-12);
  ASSERT_EQ(imported.guesses.size(), 2u);
  EXPECT_EQ(withoutFolder(imported.guesses[0]), "a.csv: t is taken as ms: it then advances at 100 Hz");
  EXPECT_EQ(imported.guesses[1],
            "pos.HeadYaw is taken as deg: pos.HeadYaw reaches 90, its limits are -2.086 to 2.086 rad");
}

TEST_F(RunImport, aStatedUnitIsNeverOverridden) {
  const std::string csv = "t,q_HeadYaw\n1000,0\n1010,45\n1020,90\n";
  for (const char* stated : {", unit: rad", ", unit: 1", ", scale: 1"}) {
    const ImportedRun imported = importAll(bareMap(", unit: s", stated), {{"a.csv", csv}});
    EXPECT_EQ(imported.run.t[1], 10);
    EXPECT_EQ((*imported.run.find("pos.HeadYaw"))[1], 45);
    EXPECT_TRUE(imported.guesses.empty());
  }
}

TEST_F(RunImport, aUnitThatIsNotClearIsAsked) {
  EXPECT_EQ(
      refused(bareMap(", unit: s", ""), {{"a.csv", "t,q_HeadYaw\n0,-2\n0.01,2\n"}}),
      "map.yaml:6: columns[0].from has no unit; pos.HeadYaw could be in rad or in deg: it moves by up to "
      "4, which is within the joints' limits in both; write unit: rad or unit: deg");
  EXPECT_EQ(
      refused(bareMap("", ", unit: rad"), {{"a.csv", "t,q_HeadYaw\n0,-2\n0.5,2\n"}}),
      "map.yaml:4: time.from has no unit; t advances by 0.5 a line, in no unit near 100 Hz; write unit: "
      "s, ms, us or ns");
}

TEST_F(RunImport, theLimitsOfAnotherRobotAreTakenFromItsFile) {
  std::string text = bareMap(", unit: s", "");
  text.replace(text.find("nao_v5"), 6, "my_leg");
  const std::vector<std::pair<std::string, std::string>> files = {{"a.csv", "t,q_HeadYaw\n0,0\n0.01,80\n"}};
  EXPECT_EQ(
      refused(text, files),
      "map.yaml:6: columns[0].from has no unit; pos.HeadYaw reaches 80, and the robot's file is not known: "
      "give it by --robot, or write unit: rad or unit: deg");
  EXPECT_NEAR(importAll(text, files, "nao_v5").run.find("pos.HeadYaw")->back(), 80 * M_PI / 180, 1e-12);
}

}  // namespace
}  // namespace plumbline::gap
