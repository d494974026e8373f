#include "gap/run/RunCheck.h"

#include <gtest/gtest.h>

#include <cmath>

#include "PendulumRun.h"
#include "gap/run/RunFile.h"

namespace plumbline::gap {
namespace {

using Recording = Run;  // gtest has a Run of its own in test classes

class RunCheck : public testing::Test {
protected:
  static Recording load(const std::string& name) {
    std::vector<RunWarning> warnings;
    return readRun("tests/data/gap/" + name, warnings);
  }

  static std::string check(Recording& run, const std::string& robot = "nao_v5") {
    return checked(run, robot);
  }

  static void scale(Recording& run, const std::string& start, double factor) {
    for (auto& [name, column] : run.channels)
      if (name.compare(0, start.size(), start) == 0)
        for (double& x : column) x *= factor;
  }
};

TEST_F(RunCheck, goodRunsPassWithoutAWord) {
  for (const char* name : {"nao_none_small", "nao_friction_sweep", "nao_friction_small", "nao_none_sway"}) {
    Recording run = load(name);
    EXPECT_EQ(check(run), "") << name;
  }
  for (const char* name : {"xl330_kp200_sin_sin", "xl330_kp100_lift_and_drop"}) {
    Recording run = load(name);
    EXPECT_EQ(check(run, "xl330_pendulum"), "") << name;
  }
  Recording run = load("so101_multisine");
  EXPECT_EQ(check(run, "so101"), "");
}

TEST_F(RunCheck, timesInAnotherUnit) {
  Recording run = load("nao_none_small");
  for (double& t : run.t) t *= 1000;
  EXPECT_EQ(check(run), "refused: r: t advances 10 s a line, but rate_hz 100 says 0.01 s; is t in ms?");
  run = load("nao_none_small");
  run.rateHz = 50;
  EXPECT_EQ(check(run),
            "refused: r: t advances 0.01 s a line, but rate_hz 50 says 0.02 s; correct one of them");
}

TEST_F(RunCheck, theWrongRobot) {
  Recording run = load("nao_none_small");
  EXPECT_EQ(
      check(run, "so101"),
      "refused: r: this is a run of another robot: so101 has no joint HeadPitch, nor most of the others");
  run = load("nao_none_small");
  run.robot = "nao_v6";
  EXPECT_EQ(check(run), "r: run.json: the run names robot nao_v6, the model is nao_v5\n");
}

TEST_F(RunCheck, joints_theRobotLacks) {
  Recording run = load("nao_none_small");
  run.channels["pos.Tail"] = run.channels["pos.LKneePitch"];
  run.channels["fsr.Tail.RearLeft"] = run.channels["pos.LKneePitch"];
  run.servo["Tail"].kp = 1;
  EXPECT_EQ(check(run),
            "r: fsr.Tail.RearLeft is left out: nao_v5 has no foot Tail\n"
            "r: pos.Tail is left out: nao_v5 has no joint Tail\n"
            "r: run.json: servo.Tail: nao_v5 has no such joint\n");
}

TEST_F(RunCheck, everythingInDegrees) {
  Recording run = load("nao_friction_sweep");
  scale(run, "cmd.", degree);
  scale(run, "pos.", degree);
  const std::string text = check(run);
  EXPECT_EQ(text.substr(0, 74), "refused: r: commands and positions are far outside the joints' limits (cmd")
      << text;
  EXPECT_NE(text.find("are these degrees?); convert to rad"), std::string::npos) << text;
}

TEST_F(RunCheck, oneColumnInDegrees) {
  Recording run = load("nao_friction_sweep");
  scale(run, "pos.LKneePitch", degree);
  EXPECT_EQ(check(run),
            "r: pos.LKneePitch is left out: it reaches 78.12, limits are -0.09233 to 2.113 rad; are these "
            "degrees?\n"
            "r: cmd.LKneePitch: there is no pos.LKneePitch to hold against it\n");
  run = load("nao_friction_sweep");
  scale(run, "cmd.LKneePitch", degree);
  const std::string text = check(run);
  EXPECT_NE(text.find("r: cmd.LKneePitch is left out: it reaches "), std::string::npos) << text;
  EXPECT_NE(text.find("are these degrees?\n"), std::string::npos) << text;
}

TEST_F(RunCheck, aJointThatFallsBeyondItsLimitsIsKept) {
  Recording run = load("nao_friction_sweep");
  std::vector<double>& pos = run.channels["pos.LKneePitch"];
  for (std::size_t i = 0; i < 60; ++i) pos[pos.size() - 60 + i] = -0.0125 * static_cast<double>(i);
  for (std::size_t i = 0; i < 30; ++i) pos[pos.size() - 90 + i] *= 1 - static_cast<double>(i) / 30;
  Recording jumps = run;
  EXPECT_EQ(
      check(run),
      "r: pos.LKneePitch: it goes 0.6452 rad beyond the joint's limits, but its command never is; kept, "
      "because the joint follows its command most of the time and is no faster than when it falls\n");
  jumps.channels["pos.LKneePitch"].back() = -3;
  EXPECT_EQ(check(jumps),
            "r: pos.LKneePitch is left out: it reaches -3, limits are -0.09233 to 2.113 rad; are these "
            "degrees?\n"
            "r: cmd.LKneePitch: there is no pos.LKneePitch to hold against it\n");
}

TEST_F(RunCheck, degreesThatStayWithinTheLimits) {
  Recording run = load("so101_multisine");
  scale(run, "cmd.Rotation", 57.3 * 0.2);
  scale(run, "pos.Rotation", 0.2);  // a small motion whose command reaches no limit in degrees
  const std::string text = check(run, "so101");
  EXPECT_EQ(text.substr(0, 44), "r: cmd.Rotation is left out: it moves 58.77 ") << text;
  EXPECT_NE(text.find("times as far as pos.Rotation; is it in degrees?"), std::string::npos) << text;
}

TEST_F(RunCheck, aCommandThatWasNotRecorded) {
  for (const char* name : {"nao_friction_sweep", "nao_friction_small"}) {
    Recording run = load(name);
    std::vector<double>& cmd = run.channels["cmd.RHipPitch"];
    std::fill(cmd.begin(), cmd.end(), -0.45);
    const std::string text = check(run);
    EXPECT_EQ(text.substr(0, 67), "r: cmd.RHipPitch is left out: it is constant while pos.RHipPitch is")
        << name << text;
    EXPECT_NE(text.find("r: pos.RHipPitch: there is no cmd.RHipPitch; the joint is moved as it was seen\n"),
              std::string::npos)
        << text;
  }
}

TEST_F(RunCheck, aJointThatIsHeldIsNoFault) {
  Recording run = load("nao_none_sway");  // wrists and head are held throughout
  const std::vector<double>& cmd = *run.find("cmd.LWristYaw");
  EXPECT_EQ(*std::max_element(cmd.begin(), cmd.end()), *std::min_element(cmd.begin(), cmd.end()));
  EXPECT_EQ(check(run), "");
}

TEST_F(RunCheck, missingColumns) {
  Recording run = load("nao_none_small");
  run.channels.erase("cmd.LKneePitch");
  run.channels.erase("pos.RKneePitch");
  run.channels.erase("cmd.HeadYaw");
  run.channels.erase("pos.HeadYaw");
  EXPECT_EQ(check(run),
            "r: run.csv: has neither cmd.HeadYaw nor pos.HeadYaw; it is held still\n"
            "r: pos.LKneePitch: there is no cmd.LKneePitch; the joint is moved as it was seen\n"
            "r: cmd.RKneePitch: there is no pos.RKneePitch to hold against it\n");
  run = load("xl330_kp200_sin_sin");
  run.channels.erase("cmd.pendulum");
  EXPECT_EQ(check(run, "xl330_pendulum"),
            "refused: r: no usable cmd column; a run needs commands and positions");
  run = load("xl330_kp200_sin_sin");
  run.channels.erase("pos.pendulum");
  EXPECT_EQ(check(run, "xl330_pendulum"),
            "refused: r: no usable pos column; a run needs commands and positions");
}

TEST_F(RunCheck, sensorsStuckOrTurnedRound) {
  Recording run = load("nao_friction_sweep");
  std::vector<double>& stuck = run.channels["pos.LKneePitch"];
  std::fill(stuck.begin(), stuck.end(), 0.85);
  for (double& x : run.channels["pos.HeadYaw"]) x = -x;
  const std::string text = check(run);
  EXPECT_EQ(text.substr(0, 84),
            "r: pos.HeadYaw is left out: it moves against cmd.HeadYaw; is its sign turned round?\n")
      << text;
  EXPECT_NE(text.find("r: pos.LKneePitch is left out: it never changes while cmd.LKneePitch moves by 1.04; "
                      "the sensor is stuck\n"),
            std::string::npos)
      << text;
}

TEST_F(RunCheck, speedsInDegreesOrWithoutSign) {
  Recording run = load("xl330_kp200_sin_sin");
  scale(run, "vel.", degree);
  std::string text = check(run, "xl330_pendulum");
  EXPECT_NE(text.find("r: vel.pendulum is left out: it reaches "), std::string::npos) << text;
  run = load("so101_multisine");
  scale(run, "vel.Pitch", degree);
  for (double& x : run.channels["vel.Elbow"]) x = std::abs(x);
  for (double& x : run.channels["vel.Wrist_Pitch"]) x = -x;
  text = check(run, "so101");
  EXPECT_NE(text.find("times the speed of pos.Pitch; is it in degrees?\n"), std::string::npos) << text;
  EXPECT_NE(text.find("r: vel.Elbow is left out: it has no sign; add to run.json: unsigned: [\"vel\"]\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("times the speed of pos.Wrist_Pitch; is its sign turned round?\n"), std::string::npos)
      << text;
}

TEST_F(RunCheck, theBodysSensorsInOtherUnits) {
  Recording run = load("nao_none_sway");
  scale(run, "acc.", 1 / 9.81);
  scale(run, "fsr.", 1 / 9.81);
  EXPECT_EQ(check(run),
            "r: acc is left out: its median length is 1 m/s^2 instead of about 9.81; check unit, and that "
            "gravity is in\n"
            "r: fsr is left out: their median sum is 5.307, the robot weighs 52.05 N; check the unit\n");
  run = load("nao_none_sway");
  scale(run, "gyro.", degree);
  const std::string text = check(run);
  EXPECT_NE(text.find("is it in degrees?"), std::string::npos) << text;
  EXPECT_EQ(run.find("gyro.x"), nullptr);
}

TEST_F(RunCheck, valuesNoSensorGives) {
  Recording run = load("xl330_kp200_sin_sin");
  scale(run, "temperature.", 10);
  run.channels["duty.pendulum"][7] = 1.7;
  EXPECT_EQ(check(run, "xl330_pendulum"),
            "r: duty.pendulum is left out: it reaches 1.7, outside -1.001 to 1.001; check its unit\n"
            "r: temperature.pendulum is left out: it reaches 300, outside -30 to 150; check its unit\n");
}

TEST_F(RunCheck, brokenTruth) {
  Recording run = load("nao_none_sway");
  for (const char* part : {"truth.qw", "truth.qx", "truth.qy", "truth.qz"})
    run.channels[part].assign(run.size(), 0.6);
  EXPECT_EQ(check(run), "r: truth is left out: a quaternion has length 1.2 instead of 1\n");
  for (const char* part : {"truth.qw", "truth.qx", "truth.qy"}) run.channels[part].assign(run.size(), 0.5);
  EXPECT_EQ(check(run), "r: truth is left out: a quaternion has four columns\n");
}

TEST_F(RunCheck, commandsInThousandsAreLeftOut) {
  Recording run = load("so101_multisine");
  scale(run, "cmd.", 1e-3);
  const std::string said = check(run, "so101");
  EXPECT_NE(said.find(" times as far; was it divided by a thousand?"), std::string::npos) << said;
}

TEST_F(RunCheck, settingsThatHardlyAreAreReportedAndUsed) {
  Recording run = load("xl330_kp200_sin_sin");
  run.servo["pendulum"].kp = 0;
  run.servo["pendulum"].vin = 7400;
  run.servo["pendulum"].kpFirmware = 400;
  EXPECT_EQ(check(run, "xl330_pendulum"),
            "r: run.json: servo.pendulum.kp is 0: the motor would do nothing; leave the key out if the value "
            "is unknown\n"
            "r: run.json: servo.pendulum.vin is 7400, 1000 times that of xl330_pendulum; check its unit\n");
}

TEST_F(RunCheck, timesThatHardlyAreAreReportedAndUsed) {
  Recording run = load("xl330_kp200_sin_sin");
  run.timing["*"] = {1, 0, 0};
  EXPECT_TRUE(check(run, "xl330_pendulum")
                  .starts_with("r: run.json: timing.cmd_at_s is 1 s, 188 cycles; is it in s?"));
  run = load("xl330_kp200_sin_sin");
  run.rateHz *= 1.2;
  EXPECT_NE(check(run, "xl330_pendulum").find("r: run.json: rate_hz "), std::string::npos);
  run = load("xl330_kp200_sin_sin");
  run.groundTruth = true;
  EXPECT_EQ(check(run, "xl330_pendulum"),
            "r: run.json: ground_truth is true, but there is no column truth.*\n");
}

TEST_F(RunCheck, clocksThatAreApartAreReported) {
  for (const int lines : {-90, 90}) {
    Recording run = load("so101_multisine");
    for (auto& [name, column] : run.channels)
      if (name.starts_with("pos.")) {
        std::vector<double> moved(column.size(), std::nan(""));
        for (std::size_t i = 0; i < column.size(); ++i) {
          const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(i) - lines;
          if (from >= 0 && from < static_cast<std::ptrdiff_t>(column.size()))
            moved[i] = column[static_cast<std::size_t>(from)];
        }
        column = moved;
      }
    const std::string said = check(run, "so101");
    EXPECT_NE(said.find(lines < 0 ? " s later; are both of one clock" : " s before; are both of one clock"),
              std::string::npos)
        << said;
  }
}

}  // namespace
}  // namespace plumbline::gap
