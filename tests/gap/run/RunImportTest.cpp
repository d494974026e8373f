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

  std::string errorOf(const std::string& from, const std::string& to, std::string csv = recording) const {
    std::string text = map;
    text.replace(text.find(from), from.size(), to);
    try {
      import(text, csv);
      return "no error";
    } catch (const ConfigurationError& error) {
      std::string what = error.what();
      for (std::size_t at; (at = what.find(folder)) != std::string::npos;) what.erase(at, folder.size() + 1);
      return what;
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

}  // namespace
}  // namespace plumbline::gap
