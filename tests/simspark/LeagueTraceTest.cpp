#include "simspark/LeagueTrace.h"

#include <gtest/gtest.h>

#include <fstream>

#include "math/Angle.h"

namespace plumbline::simspark {
namespace {

std::string errorOf(const std::string& file) {
  try {
    readLeagueTrace(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

std::string write(const std::string& text) {
  const std::string file = testing::TempDir() + "trace_t2.csv";
  std::ofstream(file) << text;
  return file;
}

TEST(LeagueTrace, readsInThisProjectsAxesAndSigns) {
  const LeagueTrace trace = readLeagueTrace("tests/data/traces/crouch_t4.csv.gz");
  EXPECT_EQ(trace.name, "crouch_t4");
  EXPECT_EQ(trace.robotType, 4);
  EXPECT_EQ(trace.rows.size(), 400u);
  EXPECT_EQ(trace.joints.size(), 24u);
  const TraceRow& bottom = trace.rows[125];
  EXPECT_NEAR(toDegrees(bottom.axisAngle[lKneePitch]), 59.99, 0.02) << "bent is positive here";
  EXPECT_NEAR(toDegrees(bottom.axisAngle[rAnklePitch]), -30, 0.02);
  EXPECT_NEAR(bottom.torso.linear()(0, 0), 1, 1e-6) << "the robot looks along the field";
  EXPECT_NEAR(bottom.leftFoot.translation().y(), 0.055, 1e-3);
  ASSERT_TRUE(bottom.leftToeForce.has_value());
  EXPECT_GT(bottom.leftToeForce->force.z(), 1);
}

TEST(LeagueTrace, typeStandsAtTheEndOfTheName) {
  EXPECT_EQ(readLeagueTrace("tests/data/traces/ball_roll_v3.csv.gz").robotType, std::nullopt);
  const LeagueTrace dotted = readLeagueTrace("tests/data/traces/ballfoot_v1.5_off0_t0.csv.gz");
  EXPECT_EQ(dotted.name, "ballfoot_v1.5_off0_t0");
  EXPECT_EQ(dotted.robotType, 0);
}

TEST(LeagueTrace, absentForceIsAbsent) {
  const LeagueTrace trace = readLeagueTrace("tests/data/traces/crouch_t0.csv.gz");
  EXPECT_FALSE(trace.rows[0].leftFootForce.has_value()) << "it is still in the air";
  EXPECT_TRUE(trace.rows[5].leftFootForce.has_value());
  EXPECT_FALSE(trace.rows[5].leftToeForce.has_value());
}

TEST(LeagueTrace, saysWhatIsWrongAndWhere) {
  EXPECT_EQ(errorOf("no/such.csv"), "no/such.csv: cannot be read; give a trace as .csv or .csv.gz");
  std::string file = write("");
  EXPECT_EQ(errorOf(file), file + ":0: is empty; the first line of a trace names its columns");
  write("cycle,gyr.x\n0\n");
  EXPECT_EQ(errorOf(file), file + ":2: has 1 fields, the header has 2");
  write("cycle,cmd.he1\n0,1\n");
  EXPECT_EQ(errorOf(file), file + ":2: the header lacks column hj.hj1");
  write("cmd.he1,hj.hj1\n0,fast\n");
  EXPECT_EQ(errorOf(file), file + ":2: column hj.hj1 is no number: fast");
  write("cmd.he1,hj.hj1\nnan,1\n");
  EXPECT_EQ(errorOf(file), file + ":2: column cmd.he1 is no number: nan");
  write("a,a\n");
  EXPECT_EQ(errorOf(file), file + ":1: the header names a column twice");
  write(std::string(70000, 'x'));
  EXPECT_EQ(errorOf(file), file + ":1: the line is longer than 65536 characters");
}

}  // namespace
}  // namespace plumbline::simspark
