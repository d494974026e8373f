#include "gap/run/RunFile.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "gap/run/RunCheck.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

using Recording = Run;  // gtest has a Run of its own in test classes

namespace fs = std::filesystem;

constexpr const char* meta =
    R"({"robot": "xl330_pendulum", "base": "fixed", "rate_hz": 100, "motion": "m", "ground_truth": false})";
constexpr const char* table = "t,cmd.pendulum,pos.pendulum\n0,0,0.1\n0.01,0.5,\n0.02,1,+1.5e-1\n";

class RunFile : public testing::Test {
protected:
  RunFile() : folder((fs::path(testing::TempDir()) / ("run" + std::to_string(getpid()))).string()) {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~RunFile() override { fs::remove_all(folder); }

  void write(const std::string& json, const std::string& csv) const {
    std::ofstream(folder + "/run.json") << json;
    std::ofstream(folder + "/run.csv") << csv;
  }

  /// The error of reading, the folder's name taken off; or the warnings.
  std::string outcome(const std::string& json, const std::string& csv) const {
    write(json, csv);
    return outcome();
  }
  std::string outcome() const {
    std::vector<RunWarning> warnings;
    std::string text;
    try {
      readRun(folder, warnings);
      for (const RunWarning& warning : warnings) text += warning.line(folder) + "\n";
    } catch (const RunError& error) {
      text = error.what();
    }
    for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size() + 1);
    return text;
  }

  const std::string folder;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST_F(RunFile, aRunIsReadWithItsGaps) {
  write(meta, table);
  std::vector<RunWarning> warnings;
  const Recording run = readRun(folder, warnings);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(run.robot, "xl330_pendulum");
  EXPECT_FALSE(run.freeBase);
  EXPECT_EQ(run.rateHz, 100);
  EXPECT_EQ(run.t, (std::vector<double>{0, 0.01, 0.02}));
  EXPECT_EQ(*run.find("cmd.pendulum"), (std::vector<double>{0, 0.5, 1}));
  const std::vector<double>& pos = *run.find(ChannelKind::position, "pendulum");
  EXPECT_EQ(pos[0], 0.1);
  EXPECT_TRUE(std::isnan(pos[1]));
  EXPECT_EQ(pos[2], 0.15);
  EXPECT_EQ(run.find("vel.pendulum"), nullptr);
  EXPECT_EQ(run.jointsWith(ChannelKind::command), std::vector<std::string>{"pendulum"});
}

TEST_F(RunFile, whatRunJsonMaySayIsKept) {
  write(
      R"({"robot": "so101", "base": "free", "rate_hz": 49.85, "motion": "m", "ground_truth": true, "heading": 3.1,
   "repeat_of": "other", "unsigned": ["current", "vel.Jaw"], "session": 2,
   "servo": {"Jaw": {"kp": 3, "dc_motor": {"kp_firmware": 100, "vin": 7.4}}},
   "timing": {"cmd_at_s": 0.001, "pos_at_s": {"Jaw": 0.005, "Elbow": 0.002}, "note": "n"}})",
      table);
  std::vector<RunWarning> warnings;
  const Recording run = readRun(folder, warnings);
  EXPECT_TRUE(run.freeBase);
  EXPECT_TRUE(run.groundTruth);
  EXPECT_EQ(run.heading, 3.1);
  EXPECT_EQ(run.repeatOf, "other");
  EXPECT_TRUE(run.isUnsigned("current.Elbow"));
  EXPECT_TRUE(run.isUnsigned("vel.Jaw"));
  EXPECT_FALSE(run.isUnsigned("vel.Elbow"));
  EXPECT_EQ(run.servo.at("Jaw").kpFirmware, 100);
  EXPECT_EQ(run.timingOf("Jaw").posAt, 0.005);
  EXPECT_EQ(run.timingOf("Jaw").cmdAt, 0.001);
  EXPECT_EQ(run.timingOf("Pitch").posAt, 0);
  EXPECT_EQ(run.timingOf("Pitch").cmdAt, 0.001);
}

TEST_F(RunFile, servoSettingsOfTheRunCount) {
  std::vector<RunWarning> warnings;
  const Recording run = readRun("tests/data/gap/xl330_kp200_sin_sin", warnings);
  const Mechanism robot = withServo(findMechanism("xl330_pendulum"), run);
  EXPECT_EQ(robot.joints[0].servo.kpFirmware, 200);
  EXPECT_EQ(robot.joints[0].servo.kp, 0.4793);
  Recording other;
  other.servo["pendulum"].vin = 3.7;
  const Servo halved = withServo(findMechanism("xl330_pendulum"), other).joints[0].servo;
  EXPECT_NEAR(halved.kp, 0.9586 / 2, 1e-4);
  other.servo["pendulum"] = {};
  other.servo["pendulum"].kp = 0.9586 / 4;
  EXPECT_NEAR(withServo(findMechanism("xl330_pendulum"), other).joints[0].servo.kpFirmware, 100, 0.02);
}

TEST_F(RunFile, whatIsWrittenIsReadAgain) {
  std::vector<RunWarning> warnings;
  Recording run = readRun("tests/data/gap/xl330_kp100_lift_and_drop", warnings);
  run.heading = 0.5;
  run.repeatOf = "x";
  (*const_cast<std::vector<double>*>(run.find("pos.pendulum")))[5] = std::nan("");
  for (const bool packed : {true, false}) {
    const std::string place = folder + "/written";
    writeRun(run, place, {6, packed});
    EXPECT_TRUE(fs::exists(place + (packed ? "/run.csv.gz" : "/run.csv")));
    EXPECT_FALSE(fs::exists(place + ".part"));
    const Recording again = readRun(place, warnings);
    EXPECT_EQ(again.t, run.t);
    EXPECT_EQ(again.channels.size(), run.channels.size());
    for (const auto& [name, column] : run.channels)
      for (std::size_t i = 0; i < column.size(); ++i) {
        const double x = (*again.find(name))[i];
        ASSERT_TRUE(x == column[i] || (std::isnan(x) && std::isnan(column[i]))) << name << " " << i;
      }
    EXPECT_EQ(again.heading, run.heading);
    EXPECT_EQ(again.repeatOf, run.repeatOf);
    EXPECT_EQ(again.timingOf("pendulum").posAt, -0.0014);
    EXPECT_EQ(again.servo.at("pendulum").vin, 7.4);
    try {
      writeRun(run, place);
      FAIL();
    } catch (const RunError& error) {
      EXPECT_EQ(std::string(error.what()), place + ": exists already; remove it or choose another folder");
    }
    fs::remove_all(place);
  }
  EXPECT_TRUE(warnings.empty());
}

TEST_F(RunFile, keysThatThereAreNotAreNamed) {
  EXPECT_EQ(outcome(replaced(meta, "\"rate_hz\"", "\"rows\": 1e9, \"rate_hz\""), table),
            "run.json: there is no key rows");
  EXPECT_EQ(outcome(replaced(meta, "\"rate_hz\"", "\"headnig\": 1, \"rate_hz\""), table),
            "run.json: there is no key headnig; did you mean \"heading\"?");
  EXPECT_EQ(outcome(replaced(meta, "\"rate_hz\"", "\"timing\": {\"pos_at\": 0}, \"rate_hz\""), table),
            "run.json: there is no key timing.pos_at; did you mean \"pos_at_s\"?");
  EXPECT_EQ(outcome(replaced(meta, "\"rate_hz\"", "\"servo\": {\"A\": {\"kpp\": 0}}, \"rate_hz\""), table),
            "run.json: there is no key servo.A.kpp; did you mean \"kp\"?");
  EXPECT_EQ(
      outcome(replaced(meta, "\"rate_hz\"", "\"servo\": {\"A\": {\"dc_motor\": {\"vinn\": 0}}}, \"rate_hz\""),
              table),
      "run.json: there is no key servo.A.dc_motor.vinn; did you mean \"vin\"?");
  EXPECT_EQ(outcome(replaced(meta, "\"rate_hz\"", "\"note\": \"by hand\", \"rate_hz\""), table), "");
}

TEST_F(RunFile, aLineWithANulIsNoEmptyLine) {
  std::string broken = table;
  broken.insert(broken.find('\n') + 1, 1, '\0');
  EXPECT_EQ(outcome(meta, broken), "run.csv:2: holds a NUL character; the file is damaged");
}

TEST_F(RunFile, badRunJsonIsNamed) {
  EXPECT_EQ(outcome("", table), "run.json:1: broken JSON");
  EXPECT_EQ(outcome("{\n\"robot\": NaN}", table), "run.json:2: broken JSON");
  EXPECT_EQ(outcome("[]", table), "run.json: is no object; write { ... }");
  EXPECT_EQ(outcome("{}", table), "run.json: robot is missing; give the robot's name");
  EXPECT_EQ(outcome(replaced(meta, "\"fixed\"", "\"hung\""), table),
            "run.json: base is \"hung\"; give \"fixed\" or \"free\"");
  EXPECT_EQ(outcome(replaced(meta, "100", "\"fast\""), table),
            "run.json: rate_hz is \"fast\"; give a number");
  EXPECT_EQ(outcome(replaced(meta, "100", "-5"), table), "run.json: rate_hz is -5, outside 0.001 to 20000");
  EXPECT_EQ(outcome(replaced(meta, "\"m\"", "[1]"), table), "run.json: motion is [1]; give what was played");
  EXPECT_EQ(outcome(replaced(meta, "false", "0"), table), "run.json: ground_truth is 0; give true or false");
  EXPECT_EQ(outcome(replaced(meta, "\"base\"", "\"robot\": \"x\", \"base\""), table),
            "run.json: key \"robot\" occurs twice in one object");
  EXPECT_EQ(outcome(replaced(meta, "\"base\"", "\"servo\": {\"J\": {\"kp\": -1}}, \"base\""), table),
            "run.json: servo.J.kp is -1, outside 0 to 1e+09");
  EXPECT_EQ(outcome(replaced(meta, "\"base\"", "\"timing\": {\"pos_at_s\": {\"J\": 5}}, \"base\""), table),
            "run.json: timing.pos_at_s.J is 5, outside -1 to 1");
  EXPECT_EQ(outcome(replaced(meta, "\"base\"", "\"unsigned\": \"vel\", \"base\""), table),
            "run.json: unsigned is \"vel\"; give a list of channels");
  fs::remove(folder + "/run.json");
  EXPECT_EQ(outcome(), "run.json: cannot be read: No such file or directory");
}

TEST_F(RunFile, runJsonIsAMegabyteAtMost) {
  const auto noted = [](std::size_t length) {
    return replaced(meta, "\"base\"", "\"note\": \"" + std::string(length, 'x') + "\", \"base\"");
  };
  EXPECT_EQ(outcome(noted(10), table), outcome(noted(900'000), table));
  EXPECT_EQ(outcome(noted(1'100'000), table), "run.json: is larger than 1 MB");
}

TEST_F(RunFile, badTablesAreNamed) {
  EXPECT_EQ(outcome(meta, ""), "run.csv: is empty; the first line names the columns");
  EXPECT_EQ(outcome(meta, "t,pos.a\n0,1\n"), "run.csv: has 1 lines of data; a run needs two at least");
  EXPECT_EQ(outcome(meta, "t,pos.a,pos.a\n0,1,2\n"), "run.csv:1: column pos.a occurs twice; leave one out");
  EXPECT_EQ(outcome(meta, "t,,pos.a\n0,1,2\n"), "run.csv:1: column 2 has no name");
  EXPECT_EQ(outcome(meta, "t,pos.a\n0,1\n0.01,2,3\n"), "run.csv:3: has 3 cells, the header has 2");
  EXPECT_EQ(outcome(meta, "time,pos.a\n0,1\n0.01,2\n"),
            "run.csv: has no column t; give the time of each line in s");
  EXPECT_EQ(outcome(meta, "t,pos.a\n0,1\n0.02,2\n0.01,2\n"),
            "run.csv: row 3 of data: t is 0.01 after 0.02; time must grow");
  EXPECT_EQ(outcome(meta, "t,pos.a\n0,1\n,2\n"),
            "run.csv: row 2 of data: t is empty; give every line its time");
  EXPECT_EQ(outcome(meta, "t,pos.a\n0,1\nnan,2\n"), "run.csv:3: t is \"nan\", no number");
  EXPECT_EQ(outcome(meta, "t" + std::string(1100, ',') + "\n"), "run.csv:1: more than 1024 columns");
  EXPECT_EQ(outcome(meta, std::string(200'000, 'x')), "run.csv:1: the line is longer than 131072 characters");
}

TEST_F(RunFile, badColumnsAreLeftOut) {
  EXPECT_EQ(
      outcome(meta, "t,cmd.a,pos.a,pos.b,mood,gyro.w\n0,0,1,,1,0\n0.01,0,nan,,1,0\n0.02,0,1e999,,1,0\n"),
      " pos.a is left out: line 3 holds \"nan\", no number; a lost sample is an empty cell\n"
      " pos.b is left out: it is empty\n"
      " mood is left out: the format has no such column\n"
      " gyro.w is left out: the format has no such column\n");
}

TEST_F(RunFile, oneTableAndOnlyOne) {
  write(meta, table);
  std::ofstream(folder + "/run.csv.gz") << "x";
  EXPECT_EQ(outcome().substr(outcome().find("holds")), "holds both run.csv and run.csv.gz; remove one");
  fs::remove(folder + "/run.csv");
  fs::remove(folder + "/run.csv.gz");
  EXPECT_EQ(outcome().substr(outcome().find("holds")), "holds no run.csv and no run.csv.gz");
}

TEST_F(RunFile, cutAndDamagedArchivesAreRefused) {
  std::ifstream stream("tests/data/gap/xl330_kp200_sin_sin/run.csv.gz", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  write(meta, "");
  fs::remove(folder + "/run.csv");
  std::vector<RunWarning> warnings;
  for (std::size_t i = 1; i < 40; ++i) {
    std::string damaged = whole;
    if (i % 2)
      damaged.resize(whole.size() * i / 40);
    else
      damaged[whole.size() * i / 40] ^= 0x55;
    std::ofstream(folder + "/run.csv.gz", std::ios::binary) << damaged;
    EXPECT_THROW(readRun(folder, warnings), RunError) << i;
  }
}

TEST_F(RunFile, anyBytesGiveARunOrAnError) {
  std::uint64_t state = 1;
  const auto next = [&](std::uint64_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (state >> 33) % below;
  };
  const std::string letters = "t,cmd.pos\n0.1eE+-\"nan \t\xff\x01";
  const Mechanism robot = findMechanism("xl330_pendulum");
  for (int i = 0; i < 500; ++i) {
    std::string csv = table, json = meta;
    for (std::uint64_t k = 1 + next(4); k > 0; --k) {
      csv[next(csv.size())] = letters[next(letters.size())];
      if (i % 3 == 0) json[next(json.size())] = letters[next(letters.size())];
    }
    write(json, csv);
    std::vector<RunWarning> warnings;
    try {
      readCheckedRun(folder, robot, warnings);
    } catch (const RunError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(FindRuns, aFolderOfRunsIsSearched) {
  EXPECT_EQ(findRuns("tests/data/gap").size(), 8u);
  EXPECT_EQ(findRuns("tests/data/gap/so101_multisine"),
            std::vector<std::string>{"tests/data/gap/so101_multisine"});
  try {
    findRuns("tests/gap");
    FAIL();
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(), "tests/gap: holds no run; a run is a folder with run.json and run.csv");
  }
}

}  // namespace
}  // namespace plumbline::gap
