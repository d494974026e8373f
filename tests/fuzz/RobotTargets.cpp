// What a user writes or brings: robots' files and recordings. Their readers take paths, so the bytes go into
// files in memory.
#include "framework/ConfigurationError.h"
#include "fuzz/Readers.h"
#include "gap/run/RunCheck.h"
#include "robot/MechanismFile.h"

namespace plumbline::fuzz {
namespace {

void checkRobot(const Mechanism& robot) {
  require(robot.links.size() == robot.joints.size() + 1, "a link without a joint");
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    require(robot.joints[j].child == static_cast<int>(j) + 1 && robot.joints[j].parent <= static_cast<int>(j),
            "a child before its parent");
    require(robot.joints[j].servo.kp >= 0 && robot.joints[j].maxTorque > 0, "a joint without a motor");
  }
  linkPoses(robot, std::vector<double>(robot.joints.size(), 0.1));
}

constexpr const char* urdf = R"(<robot name="mast"><link name="plate"/>
<link name="arm"><inertial><origin xyz="0 0 1" rpy="0 0 1.5"/><mass value="1"/><inertia ixx="1" iyy="2" izz="1.5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="tool"/><joint name="turn" type="revolute"><origin xyz="1 0 0"/><parent link="plate"/><child link="arm"/><axis xyz="0 0 2"/><limit lower="-1" upper="1" effort="2" velocity="3"/></joint>
<joint name="grip" type="fixed"><origin xyz="0 2 1"/><parent link="arm"/><child link="tool"/></joint></robot>
---8<---
joints: {turn: {kp: 1, kd: 0.1, armature: 0.01}}
imu: {link: tool}
)";
constexpr const char* mjcf =
    R"(<mujoco model="mast"><compiler angle="radian" autolimits="true"/><include file="part.xml"/><worldbody><body name="arm">
<inertial pos="0 0 1" mass="1" diaginertia="1 2 1.5"/><joint name="turn" axis="0 1 0" range="-1 1" frictionloss="0.1" damping="0.2"/>
<body name="tool" pos="0 0 1"><geom size="0.1"/><joint name="grip" type="slide"/></body></body></worldbody></mujoco>
---8<---
<mujoco><default><position kp="3" gear="2"/></default><actuator><position joint="turn" dampratio="1" forcerange="-1 1"/><motor joint="grip" ctrlrange="-2 2"/></actuator></mujoco>
)";
constexpr const char* recording =
    R"({"robot": "xl330_pendulum", "base": "fixed", "rate_hz": 100, "motion": "m", "ground_truth": false, "unsigned": ["current"],
"servo": {"pendulum": {"kp": 3, "dc_motor": {"vin": 7.4}}}, "timing": {"cmd_at_s": 0.001, "pos_at_s": {"pendulum": 0.002}}}
---8<---
t,cmd.pendulum,pos.pendulum,vel.pendulum,stiffness.pendulum
0,0,0.1,0,1
0.01,0.5,,1,1
0.02,1,+1.5e-1,0.5,0
0.03,1,0.2,0.4,1
)";

}  // namespace

void robotFile(std::string_view bytes) {
  try {
    checkRobot(readMechanism(scratchFile("robot.json", bytes), expectOneLine));
  } catch (const MechanismError& error) {
    expectOneLine(error.what());
  }
}

/// A URDF and its servo table.
void urdfFile(std::string_view bytes) {
  const auto [robot, table] = halves(bytes);
  scratchFile("robot.servo.yaml", table);
  try {
    checkRobot(readMechanism(scratchFile("robot.urdf", robot), expectOneLine));
  } catch (const MechanismError& error) {
    expectOneLine(error.what());
  }
}

/// A model of MuJoCo and what it includes.
void mjcfFile(std::string_view bytes) {
  const auto [robot, part] = halves(bytes);
  scratchFile("part.xml", part);
  try {
    checkRobot(readMechanism(scratchFile("robot.xml", robot), expectOneLine));
  } catch (const MechanismError& error) {
    expectOneLine(error.what());
  }
}

/// run.json and run.csv.
void gapRun(std::string_view bytes) {
  static const Mechanism robot = findMechanism("xl330_pendulum");
  const auto [meta, table] = halves(bytes);
  scratchFile("run.json", meta);
  scratchFile("run.csv", table);
  std::vector<gap::RunWarning> warnings;
  try {
    const gap::Run run = gap::readCheckedRun(scratchFolder(), robot, warnings);
    for (const auto& [name, column] : run.channels)
      require(column.size() == run.size(), "a column of another length");
    require(run.size() >= 2 && run.find("pos.pendulum") && run.find("cmd.pendulum"), "a run without motion");
  } catch (const gap::RunError& error) {
    expectOneLine(error.what());
  }
  for (const gap::RunWarning& warning : warnings) expectOneLine(warning.line("r"));
}

std::vector<std::string> robotFileSeeds() {
  return {contentOf("config/robots/xl330_pendulum.json"), contentOf("config/robots/so101.json")};
}
std::vector<std::string> urdfFileSeeds() { return {urdf}; }
std::vector<std::string> mjcfFileSeeds() { return {mjcf}; }
std::vector<std::string> gapRunSeeds() { return {recording}; }

namespace {
const Registered robotFileTarget({"robotFile", robotFile, robotFileSeeds, 1200});
const Registered urdfFileTarget({"urdfFile", urdfFile, urdfFileSeeds, 2000});
const Registered mjcfFileTarget({"mjcfFile", mjcfFile, mjcfFileSeeds, 2000});
const Registered gapRunTarget({"gapRun", gapRun, gapRunSeeds, 2000});
}  // namespace

}  // namespace plumbline::fuzz
