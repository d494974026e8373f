#include "robot/MechanismFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "framework/Json.h"
#include "framework/ReadFile.h"
#include "framework/YamlDocument.h"
#include "robot/FeltInertias.h"
#include "robot/MechanismParts.h"

namespace plumbline {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t maxFileSize = 4 << 20;
constexpr int maxDepth = 16;

std::string readText(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error))
    failMechanism(path, "is a folder; give a .json, .urdf, or MuJoCo's .xml file");
  try {
    return readFile(path, maxFileSize);
  } catch (const FileProblem& problem) {
    failMechanism(path, problem.what());
  }
}

json jsonOf(const std::string& text, const std::string& path) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) failMechanism(path + ":1", "is empty");
  try {
    return parseJson(text, path);
  } catch (const JsonError& error) {
    throw MechanismError(error.what());
  }
}

json jsonOfYaml(const YAML::Node& node, const std::string& path, int depth, std::size_t& count) {
  if (depth > maxDepth || ++count > 100000) failMechanism(path, "is too deep or too long for a servo table");
  if (node.IsMap()) {
    json object = json::object();
    for (const auto& entry : node) {
      const std::string key = entry.first.Scalar();
      if (object.contains(key))
        failMechanism(path + ":" + std::to_string(entry.first.Mark().line + 1),
                      "key \"" + key.substr(0, 60) + "\" occurs twice");
      object[key] = jsonOfYaml(entry.second, path, depth + 1, count);
    }
    return object;
  }
  if (node.IsSequence()) {
    json list = json::array();
    for (const auto& element : node) list.push_back(jsonOfYaml(element, path, depth + 1, count));
    return list;
  }
  if (!node.IsScalar()) return nullptr;
  const std::string& text = node.Scalar();
  double number = 0;
  const char* begin = text.data() + (!text.empty() && text[0] == '+');
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && node.Tag() != "!") return number;
  return text;
}

json servoTableOfYaml(const std::string& text, const std::string& path) {
  try {
    std::size_t count = 0;
    return jsonOfYaml(parseYaml(text, path), path, 0, count);
  } catch (const ConfigurationError& error) {
    throw MechanismError(error.what());
  } catch (const YAML::Exception& error) {
    failMechanism(path + ":" + std::to_string(error.mark.line + 1), "broken YAML: " + error.msg);
  }
}

/// Null if there is none; path: of the existing table.
json findServoTable(const fs::path& urdf, std::string& path) {
  const fs::path stem = fs::path(urdf).replace_extension();
  for (const char* ending : {".servo.json", ".servo.yaml", ".servo.yml"}) {
    path = stem.string() + ending;
    std::error_code error;
    if (!fs::exists(path, error)) continue;
    const std::string text = readText(path);
    return std::string_view(ending) == ".servo.json" ? jsonOf(text, path) : servoTableOfYaml(text, path);
  }
  return nullptr;
}

json readServoTable(const fs::path& urdf, std::string& path) {
  json table = findServoTable(urdf, path);
  if (table.is_null())
    failMechanism(urdf.string(),
                  "has no servo table; write one next to it: " + urdf.stem().string() + ".servo.json");
  return table;
}

/// A joint that nothing drives moves by nothing.
void checkGains(const MechanismParts& parts, const std::string& path) {
  for (const MechanismParts::Joint& part : parts.joints)
    if (!part.fixed && !part.isDriven)
      failMechanism(path, "joint " + part.joint.name +
                              " has no actuator; give it one, or a servo table next to the file: " +
                              fs::path(path).stem().string() + ".servo.json");
}

/// MuJoCo's damping by ratio: of the critical one that a joint has at zero, with all others still.
void addDamping(const MechanismParts& parts, Mechanism& robot) {
  const std::vector<double> inertias = feltInertias(robot, std::vector<double>(robot.joints.size(), 0));
  for (const MechanismParts::Joint& part : parts.joints) {
    const int index = part.dampRatio > 0 ? robot.jointIndex(part.joint.name) : -1;
    if (index < 0) continue;
    const auto j = static_cast<std::size_t>(index);
    Servo& servo = robot.joints[j].servo;
    servo.kd += part.dampRatio * 2 * std::sqrt(servo.kp * inertias[j]);
  }
}

/// The robot's file in a folder of robots.
std::optional<fs::path> fileOf(const std::string& name, const fs::path& folder) {
  std::error_code error;
  for (const char* ending : {".json", ".urdf", ".xml"})
    if (const fs::path path = folder / (name + ending); fs::exists(path, error)) return path;
  return std::nullopt;
}

}  // namespace

Mechanism readMechanism(const std::string& path, const MechanismWarnings& warn) {
  const std::string ending = fs::path(path).extension().string();
  MechanismParts parts;
  if (ending == ".json") {
    parts = partsOfJson(jsonOf(readText(path), path), path);
  } else if (ending == ".urdf") {
    parts = partsOfUrdf(readText(path), path);
    std::string tablePath;
    const json table = readServoTable(path, tablePath);
    applyServoTable(table, tablePath, parts);
  } else if (ending == ".xml" || ending == ".mjcf") {
    parts = partsOfMjcf(readText(path), path);
    std::string tablePath;
    if (const json table = findServoTable(path, tablePath); !table.is_null())
      applyServoTable(table, tablePath, parts);
    checkGains(parts, path);
  } else {
    failMechanism(path, "is no robot's file; give a .json, .urdf, or MuJoCo's .xml file");
  }
  Mechanism mechanism = assemble(parts, path);
  addDamping(parts, mechanism);
  for (const std::string& warning : parts.warnings)
    if (warn) warn(warning);
  checkMechanism(mechanism, path, warn);
  return mechanism;
}

bool isKnownMechanism(const std::string& name) { return fileOf(name, configPath("robots")).has_value(); }

Mechanism findMechanism(const std::string& name, const std::string& givenFolder) {
  const std::string folder = givenFolder.empty() ? configPath("robots") : givenFolder;
  checkName(name, "robot", folder);
  std::set<std::string> known;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string ending = entry.path().extension().string(), stem = entry.path().stem().string();
    if ((ending == ".json" || ending == ".urdf" || ending == ".xml") && stem.find('.') == std::string::npos)
      known.insert(stem);
  }
  if (const auto path = fileOf(name, folder)) return readMechanism(path->string());
  std::string list;
  for (const std::string& robot : known) list += (list.empty() ? "" : ", ") + robot;
  failMechanism(folder, "no robot " + name + "; there are " + (list.empty() ? "none" : list) +
                            "; give the robot's file");
}

Mechanism namedMechanism(const std::string& nameOrFile) {
  return nameOrFile.find_first_of("/.") == std::string::npos ? findMechanism(nameOrFile)
                                                             : readMechanism(nameOrFile);
}

}  // namespace plumbline
