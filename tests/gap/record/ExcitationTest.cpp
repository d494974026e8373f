#include "gap/record/Excitation.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "framework/ConfigurationError.h"
#include "gap/record/ExcitationFile.h"
#include "gap/record/Postures.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

std::vector<double> column(const CommandTable& table, const Mechanism& robot, const char* joint) {
  return table.commands[static_cast<std::size_t>(robot.jointIndex(joint))];
}

double range(const std::vector<double>& x) {
  return *std::max_element(x.begin(), x.end()) - *std::min_element(x.begin(), x.end());
}

std::string errorOf(const std::string& text) {
  const std::string path = testing::TempDir() + "/program" + std::to_string(getpid()) + ".yaml";
  std::ofstream(path) << text;
  std::string what = "no error";
  try {
    readExcitation(path, findMechanism("nao_v5"));
  } catch (const ConfigurationError& error) {
    what = std::string(error.what()).substr(path.size() + 1);
  }
  std::filesystem::remove(path);
  return what;
}

TEST(Excitation, everyStandardProgramMovesWithinLimitsAndSpeed) {
  const Mechanism nao = findMechanism("nao_v5");
  std::vector<std::string> names = hangingBattery();
  for (const std::string& name : floatingBaseBattery()) names.push_back(name);
  names.insert(names.end(), {"hang_static", "hang_chirp"});
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const Excitation program = findExcitation(name, nao);
    EXPECT_EQ(program.freeBase, name[0] == 's');
    const CommandTable table = playExcitation(program, nao, 100);
    EXPECT_GT(table.t.back(), 12);
    EXPECT_LT(table.t.back(), 30);
    for (std::size_t j = 0; j < nao.joints.size(); ++j) {
      const std::vector<double>& command = table.commands[j];
      ASSERT_EQ(command.size(), table.t.size());
      EXPECT_GT(*std::min_element(command.begin(), command.end()), nao.joints[j].lower);
      EXPECT_LT(*std::max_element(command.begin(), command.end()), nao.joints[j].upper);
      EXPECT_EQ(command.front(),
                std::clamp(program.posture[j], nao.joints[j].lower + 0.001, nao.joints[j].upper - 0.001));
      EXPECT_TRUE(program.freeBase || range(command) > 0.05) << nao.joints[j].name;
      if (name == "hang_multisine" || name == "hang_chirp") {
        for (std::size_t i = 1; i < command.size(); ++i)
          ASSERT_LT(std::abs(command[i] - command[i - 1]) * 100, nao.joints[j].maxSpeed)
              << nao.joints[j].name;
      }
    }
    // One motor moves both hips.
    EXPECT_EQ(column(table, nao, "LHipYawPitch"), column(table, nao, "RHipYawPitch"));
  }
}

TEST(Excitation, commandsKeepAHundredthOfARadianFromTheStops) {
  const Mechanism nao = findMechanism("nao_v5");
  Excitation program = findExcitation("hang_static", nao);
  for (Segment& segment : program.segments)
    for (auto& [joint, amplitude] : segment.joints) amplitude = 9;
  const CommandTable table = playExcitation(program, nao, 100);
  for (std::size_t j = 0; j < nao.joints.size(); ++j) {
    const Mechanism::Joint& joint = nao.joints[j];
    const double margin = std::min(0.0099, 0.0099 * (joint.upper - joint.lower));
    const auto [low, high] = std::ranges::minmax(table.commands[j]);
    EXPECT_GE(low, joint.lower + margin) << joint.name;
    EXPECT_LE(high, joint.upper - margin) << joint.name;
  }
}

TEST(Excitation, otherRobotsPlayTheHangingPrograms) {
  for (const char* name : {"so101", "xl330_pendulum"}) {
    const Mechanism robot = findMechanism(name);
    for (const std::string& program : hangingBattery()) {
      const CommandTable table = playExcitation(findExcitation(program, robot), robot, robot.controlHz);
      for (const std::vector<double>& command : table.commands)
        EXPECT_GT(range(command), 0.05) << name << program;
    }
  }
}

TEST(Excitation, theSweepTakesOneJointOfALimbAtATime) {
  const Mechanism nao = findMechanism("nao_v5");
  const std::vector<std::vector<int>> groups = jointsInTurn(nao);
  EXPECT_EQ(groups.size(), 6u);
  std::multiset<int> all;
  for (const std::vector<int>& group : groups)
    for (std::size_t a = 0; a < group.size(); ++a) {
      all.insert(group[a]);
      for (std::size_t b = 0; b < a; ++b) {  // no two on one way to the torso
        const std::vector<int> up = nao.chain(group[a] + 1), down = nao.chain(group[b] + 1);
        EXPECT_EQ(std::count(up.begin(), up.end(), group[b]) + std::count(down.begin(), down.end(), group[a]),
                  0);
      }
    }
  EXPECT_EQ(all.size(), 23u);  // all but the hip that another motor drives
  EXPECT_EQ(all.count(nao.jointIndex("RHipYawPitch")), 0u);
}

TEST(Excitation, loadingsTurnGravityRound) {
  const Mechanism nao = findMechanism("nao_v5");
  const std::vector<double> home = *namedPosture("hang", nao, "config/excitation");
  const auto loadings = gravityLoadings(nao, home, 0.65, 4, 3);
  ASSERT_EQ(loadings.size(), 4u);
  for (const char* name : {"LHipPitch", "RShoulderPitch", "LKneePitch", "HeadPitch"}) {
    const auto j = static_cast<std::size_t>(nao.jointIndex(name));
    double low = 1e9, high = -1e9;
    for (const std::vector<double>& q : loadings) {
      low = std::min(low, gravityTorques(nao, q)[j]);
      high = std::max(high, gravityTorques(nao, q)[j]);
    }
    EXPECT_GT(high - low, 0.1) << name;
  }
}

TEST(Excitation, gravityTorquesOfAPendulum) {
  const Mechanism robot = findMechanism("xl330_pendulum");
  EXPECT_NEAR(gravityTorques(robot, {0})[0], 0, 1e-12);
  // The weight swings about y: at 90 degrees it is at -x, gravity turns it back, the motor holds against it.
  EXPECT_NEAR(gravityTorques(robot, {M_PI / 2})[0], 0.49 * 0.1 * 9.80665, 1e-9);
}

TEST(Excitation, seedsChangeWhatIsRandomAndNothingElse) {
  const Mechanism nao = findMechanism("nao_v5");
  const auto commands = [&](const char* name, std::uint64_t seed) {
    return playExcitation(findExcitation(name, nao, seed), nao, 100).commands;
  };
  EXPECT_EQ(commands("hang_multisine", 4), commands("hang_multisine", 4));
  EXPECT_NE(commands("hang_multisine", 4), commands("hang_multisine", 5));
  EXPECT_NE(commands("hang_small", 4), commands("hang_small", 5));
  EXPECT_EQ(commands("hang_sweep", 4), commands("hang_sweep", 5));
}

TEST(Excitation, aWrittenProgramReadsAsTheSame) {
  const Mechanism nao = findMechanism("nao_v5");
  for (const char* name : {"hang_small", "hang_fast", "stand_lean", "hang_sweep"}) {
    const Excitation program = findExcitation(name, nao, 2);
    const std::string path = testing::TempDir() + "/written" + std::to_string(getpid()) + ".yaml";
    std::ofstream(path) << excitationText(program, nao);
    const CommandTable a = playExcitation(program, nao, 100),
                       b = playExcitation(readExcitation(path, nao), nao, 100);
    ASSERT_EQ(a.t.size(), b.t.size()) << name;
    for (std::size_t j = 0; j < a.commands.size(); ++j)
      for (std::size_t i = 0; i < a.t.size(); ++i)
        ASSERT_NEAR(a.commands[j][i], b.commands[j][i], 1e-6) << name << nao.joints[j].name << " " << i;
    std::filesystem::remove(path);
  }
}

TEST(Excitation, walksAreFilesToo) {
  const Mechanism nao = findMechanism("nao_v5");
  const Excitation forward = findExcitation("walk_forward", nao);
  ASSERT_TRUE(forward.walk);
  EXPECT_EQ(forward.about, "walk_forward: the project's own walk, closed loop");
  EXPECT_EQ(forward.walk->velocity, Vec2(0.15, 0));
  EXPECT_EQ(forward.walk->duration, 10);
  EXPECT_EQ(forward.duration, 12);
  EXPECT_TRUE(forward.freeBase);
  EXPECT_EQ(findExcitation("walk_sideways", nao).walk->velocity, Vec2(0, 0.06));
  EXPECT_EQ(findExcitation("walk_turn", nao).walk->turn, 0.4);
  EXPECT_THROW(playExcitation(forward, nao, 100), std::invalid_argument);
  EXPECT_THROW(excitationText(forward, nao), std::invalid_argument);
  EXPECT_EQ(errorOf("about: a\nbase: fixed\nwalk: {forward: 0.1, duration: 1}\n"),
            "3: walk.forward needs base: free; a robot with a fixed base does not walk");
  EXPECT_EQ(errorOf("about: a\nbase: free\nwalk: {foward: 0.1, duration: 1}\n"),
            "3: unknown key \"walk.foward\"; did you mean \"forward\"?");
}

TEST(Excitation, badProgramsAreNamed) {
  const std::string head = "about: a\nbase: fixed\nposture: hang\nsegments:\n";
  EXPECT_EQ(
      errorOf(head + "  - {wave: square, duration: 1, amplitude: 1}\n"),
      "5: segments[0].wave must be triangle, chirp, steps, sine, multisine, fast or bumps, not \"square\"");
  EXPECT_EQ(errorOf(head + "  - {wave: sine, duration: 1, amplitude: 1, joints: {LKneePich: 1}}\n"),
            "5: segments[0].joints.LKneePich is no joint of nao_v5; did you mean \"LKneePitch\"?");
  EXPECT_EQ(errorOf(head + "  - {wave: sine, duration: 1, amplitude: 1, joints: [Tail]}\n"),
            "5: segments[0].joints names Tail, which is no joint of nao_v5");
  EXPECT_EQ(errorOf(head + "  - {wave: sine, duration: 1}\n"),
            "5: segments[0].wave needs amplitude or share, one of them");
  EXPECT_EQ(errorOf(head + "  - {wave: sine, duration: 1, amplitude: 1, hertz: 1}\n").substr(0, 14),
            "5: unknown key");
  EXPECT_EQ(errorOf(head + "  - {hold: 3000}\n  - {hold: 3000}\n"),
            "6: segments[1].hold makes the program longer than an hour");
  EXPECT_EQ(errorOf(head + "  - {hold: 1800}\n  - {hold: 1900}\n"),
            "6: segments[1].hold makes the program longer than an hour");
  EXPECT_EQ(errorOf("about: a\nbase: fixed\nposture: sit\nsegments: []\n"),
            "3: posture is \"sit\", a posture that postures.yaml does not have for nao_v5");
  try {
    findExcitation("dance", findMechanism("nao_v5"));
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(),
                 "config/excitation: no program dance; there are hang_chirp, hang_fast, hang_multisine, "
                 "hang_small, hang_static, "
                 "hang_sweep, stand_lean, stand_squat, stand_sway, stand_turn180, stand_walk, walk_forward, "
                 "walk_sideways, walk_turn");
  }
}

}  // namespace
}  // namespace plumbline::gap
