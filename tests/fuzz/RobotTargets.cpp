// What a user writes or brings: robots' files and recordings. Their readers take paths, so the bytes go into
// files in memory.
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "framework/ConfigurationError.h"
#include "fuzz/Targets.h"
#include "gap/run/RunCheck.h"
#include "robot/MechanismFile.h"

namespace plumbline::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view separator = "\n---\n";

/// A folder that goes with the process.
class Folder {
public:
  Folder() {
    std::error_code error;
    const fs::path memory = fs::is_directory("/dev/shm", error) ? "/dev/shm" : fs::temp_directory_path();
    path = memory / ("fuzz" + std::to_string(getpid()));
    fs::create_directories(path);
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path, error);
  }
  std::string write(const char* name, std::string_view bytes) const {
    std::ofstream(path / name, std::ios::binary) << bytes;
    return (path / name).string();
  }
  fs::path path;
};

const Folder& folder() {
  static const Folder one;
  return one;
}

std::array<std::string_view, 2> halves(std::string_view bytes) {
  const std::size_t at = bytes.find(separator);
  if (at == std::string_view::npos) return {bytes, ""};
  return {bytes.substr(0, at), bytes.substr(at + separator.size())};
}

void checkRobot(const Mechanism& robot) {
  require(robot.links.size() == robot.joints.size() + 1, "a link without a joint");
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    require(robot.joints[j].child == static_cast<int>(j) + 1 && robot.joints[j].parent <= static_cast<int>(j),
            "a child before its parent");
    require(robot.joints[j].servo.kp > 0 && robot.joints[j].maxTorque > 0, "a joint without a motor");
  }
  linkPoses(robot, std::vector<double>(robot.joints.size(), 0.1));
}

void expectOneLine(const std::string& what) {
  require(!what.empty() && what.find('\n') == std::string::npos, "an error of more than one line");
}

std::string contentOf(const char* path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

constexpr const char* urdf = R"(<robot name="mast"><link name="plate"/>
<link name="arm"><inertial><origin xyz="0 0 1" rpy="0 0 1.5"/><mass value="1"/><inertia ixx="1" iyy="2" izz="1.5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="tool"/><joint name="turn" type="revolute"><origin xyz="1 0 0"/><parent link="plate"/><child link="arm"/><axis xyz="0 0 2"/><limit lower="-1" upper="1" effort="2" velocity="3"/></joint>
<joint name="grip" type="fixed"><origin xyz="0 2 1"/><parent link="arm"/><child link="tool"/></joint></robot>
---
joints: {turn: {kp: 1, kd: 0.1, armature: 0.01}}
imu: {link: tool}
)";
constexpr const char* recording =
    R"({"robot": "xl330_pendulum", "base": "fixed", "rate_hz": 100, "motion": "m", "ground_truth": false, "unsigned": ["current"],
"servo": {"pendulum": {"kp": 3, "dc_motor": {"vin": 7.4}}}, "timing": {"cmd_at_s": 0.001, "pos_at_s": {"pendulum": 0.002}}}
---
t,cmd.pendulum,pos.pendulum,vel.pendulum,stiffness.pendulum
0,0,0.1,0,1
0.01,0.5,,1,1
0.02,1,+1.5e-1,0.5,0
0.03,1,0.2,0.4,1
)";

}  // namespace

void robotFile(std::string_view bytes) {
  try {
    checkRobot(readMechanism(folder().write("robot.json", bytes), expectOneLine));
  } catch (const MechanismError& error) {
    expectOneLine(error.what());
  }
}

void urdfFile(std::string_view bytes) {
  const auto [robot, table] = halves(bytes);
  folder().write("robot.servo.yaml", table);
  try {
    checkRobot(readMechanism(folder().write("robot.urdf", robot), expectOneLine));
  } catch (const MechanismError& error) {
    expectOneLine(error.what());
  }
}

void gapRun(std::string_view bytes) {
  static const Mechanism robot = findMechanism("xl330_pendulum");
  const auto [meta, table] = halves(bytes);
  folder().write("run.json", meta);
  folder().write("run.csv", table);
  std::vector<gap::RunWarning> warnings;
  try {
    const gap::Run run = gap::readCheckedRun(folder().path.string(), robot, warnings);
    for (const auto& [name, column] : run.channels)
      require(column.size() == run.size(), "a column of another length");
    require(run.size() >= 2 && run.find("pos.pendulum") && run.find("cmd.pendulum"), "a run without motion");
  } catch (const gap::RunError& error) {
    expectOneLine(error.what());
  }
  for (const gap::RunWarning& warning : warnings) expectOneLine(warning.line("r"));
}

std::vector<std::string> robotSeeds() {
  return {contentOf("config/robots/xl330_pendulum.json"), contentOf("config/robots/so101.json")};
}
std::vector<std::string> urdfSeeds() { return {urdf}; }
std::vector<std::string> runSeeds() { return {recording}; }

}  // namespace plumbline::fuzz
