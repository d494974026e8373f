#include "simspark/LeagueRecording.h"

#include <gtest/gtest.h>

#include "support/TraceWriter.h"

namespace plumbline::simspark {
namespace {

namespace fs = std::filesystem;

class LeagueRecordingTest : public testing::Test {
protected:
  LeagueRecordingTest() : folder(testing::TempDir() + "recording") {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }

  fs::path write(const std::string& name, std::size_t rows = 3) const {
    test::writeTrace(folder / name, {headYaw}, std::vector<TraceRow>(rows));
    return folder / name;
  }

  static std::string names(const fs::path& file) {
    std::string all;
    try {
      for (const LeagueTrace& trace : readLeagueRecording(file))
        all += trace.name + " " + std::to_string(trace.robotType.value_or(-1)) + ", ";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return all;
  }

  fs::path folder;
};

TEST_F(LeagueRecordingTest, nameSaysRobotAndType) {
  const auto is = [](const char* file, const char* recording, int robot, int type) {
    const TraceName name = traceName(file);
    EXPECT_EQ(name.recording, recording) << file;
    EXPECT_EQ(name.robot.value_or(-1), robot) << file;
    EXPECT_EQ(name.type.value_or(-1), type) << file;
  };
  is("a/b_v1.5_t3.csv.gz", "b_v1.5_t3", -1, 3);
  is("b_r2t4.csv", "b", 2, 4);
  is("b_t0_r11t1.csv", "b_t0", 11, 1);
  for (const char* none : {"b_t5", "b_r0t1", "b_rt1", "bt1", "b_r2t", "t1", "b_r123t1"})
    is(none, none, -1, -1);
}

TEST_F(LeagueRecordingTest, holdsAllRobotsInTheirOrder) {
  write("duel_r2t3.csv");
  write("duel_r10t1.csv");
  const fs::path first = write("duel_r1t0.csv");
  write("dual_r2t3.csv");
  write("duel_r1t0.txt");
  EXPECT_EQ(names(first), "duel_r1t0 0, duel_r2t3 3, duel_r10t1 1, ");
  EXPECT_EQ(names(folder / "duel_r10t1.csv"), names(first));
}

TEST_F(LeagueRecordingTest, robotOneNeedsNoNumber) {
  const fs::path first = write("push_t0.csv");
  EXPECT_EQ(names(first), "push_t0 0, ");
  write("push_t0_r2t4.csv");
  EXPECT_EQ(names(first), "push_t0 0, push_t0_r2t4 4, ");
  EXPECT_EQ(names(folder / "push_t0_r2t4.csv"), names(first));
}

TEST_F(LeagueRecordingTest, saysWhatDoesNotBelongTogether) {
  const fs::path first = write("a_r1t0.csv");
  const fs::path second = write("a_r2t0.csv", 4);
  EXPECT_EQ(names(first), second.string() + ": has 4 rows, " + first.string() +
                              " has 3; robots of one recording have as many");
  write("a_r2t1.csv");
  EXPECT_EQ(names(first), folder.string() + ": robot 2 of a is in two files; move one of them away");
  EXPECT_EQ(names(folder / "no" / "b_t0.csv"),
            (folder / "no" / "b_t0.csv").string() + ": cannot be read; give a trace as .csv or .csv.gz");
}

}  // namespace
}  // namespace plumbline::simspark
