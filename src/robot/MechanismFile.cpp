#include "robot/MechanismFile.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "robot/MechanismParts.h"

namespace plumbline {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t maxFileSize = 4 << 20;
constexpr int maxDepth = 16;

std::string readText(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) failMechanism(path, "is a folder; give a .json or .urdf file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) failMechanism(path, std::string("cannot be read: ") + std::strerror(errno));
  std::string text(maxFileSize + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) failMechanism(path, std::string("cannot be read: ") + std::strerror(errno));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > maxFileSize) failMechanism(path, "is larger than 4 MB; a robot's file is smaller");
  return text;
}

json parseJson(const std::string& text, const std::string& path) {
  std::vector<std::set<std::string>> keys;
  const auto check = [&](int depth, json::parse_event_t event, json& value) {
    if (depth > maxDepth)
      failMechanism(path, "is nested deeper than " + std::to_string(maxDepth) + " levels");
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      failMechanism(path,
                    "key \"" + value.get<std::string>().substr(0, 60) + "\" occurs twice in one object");
    return true;
  };
  try {
    return json::parse(text, check);
  } catch (const json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    failMechanism(path + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')),
                  text.find_first_not_of(" \t\r\n") == std::string::npos ? "is empty" : "broken JSON");
  } catch (const json::exception&) {
    failMechanism(path, "holds a number that is too large");
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

json parseYaml(const std::string& text, const std::string& path) {
  try {
    std::size_t count = 0;
    return jsonOfYaml(YAML::Load(text), path, 0, count);
  } catch (const YAML::Exception& error) {
    failMechanism(path + ":" + std::to_string(error.mark.line + 1), "broken YAML: " + error.msg);
  }
}

json readServoTable(const fs::path& urdf, std::string& path) {
  const fs::path stem = fs::path(urdf).replace_extension();
  for (const char* ending : {".servo.json", ".servo.yaml", ".servo.yml"}) {
    path = stem.string() + ending;
    std::error_code error;
    if (!fs::exists(path, error)) continue;
    const std::string text = readText(path);
    return std::string_view(ending) == ".servo.json" ? parseJson(text, path) : parseYaml(text, path);
  }
  failMechanism(urdf.string(),
                "has no servo table; write one beside it: " + stem.filename().string() + ".servo.json");
}

}  // namespace

Mechanism readMechanism(const std::string& path) {
  const std::string ending = fs::path(path).extension().string();
  if (ending == ".json") return assemble(partsOfJson(parseJson(readText(path), path), path), path);
  if (ending != ".urdf") failMechanism(path, "is no robot's file; give a .json or .urdf file");
  MechanismParts parts = partsOfUrdf(readText(path), path);
  std::string tablePath;
  const json table = readServoTable(path, tablePath);
  applyServoTable(table, tablePath, parts);
  return assemble(parts, path);
}

Mechanism findMechanism(const std::string& name, const std::string& folder) {
  checkName(name, "robot", folder);
  for (const char* ending : {".json", ".urdf"}) {
    const fs::path path = fs::path(folder) / (name + ending);
    std::error_code error;
    if (fs::exists(path, error)) return readMechanism(path.string());
  }
  std::set<std::string> known;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string ending = entry.path().extension().string(), stem = entry.path().stem().string();
    if ((ending == ".json" || ending == ".urdf") && stem.find('.') == std::string::npos) known.insert(stem);
  }
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
