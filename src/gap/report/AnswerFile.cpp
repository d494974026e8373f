#include "gap/report/AnswerFile.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "framework/Json.h"
#include "framework/ReadFile.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw ConfigurationError(path + ": " + what + "; bin/gap diagnose RUNS --json FILE writes an answer");
}

bool isText(const json& j, const char* key) { return j.contains(key) && j[key].is_string(); }

void checkPlace(const std::string& path, const json& cause, const std::string& name) {
  if (!cause.is_object()) refuse(path, name + " is no map");
  if (!isText(cause, "effect") || !isText(cause, "at")) refuse(path, name + " lacks 'effect' or 'at'");
  if (cause.contains("axis") && !cause["axis"].is_null() && !cause["axis"].is_string())
    refuse(path, name + " has an 'axis' that is no text");
}

/// A file that holds a JSON map; written: the command that writes such files.
json readMap(const std::string& path, const std::string& what, const std::string& written) {
  constexpr std::uintmax_t longest = 256ULL << 20;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw ConfigurationError(path + ": there is no such file");
  if (std::filesystem::file_size(path, error) > longest)
    throw ConfigurationError(path + ": is too long for " + what + "; " + written);
  json map;
  try {
    map = parseJson(readFile(path, longest), path);
  } catch (const FileProblem& problem) {
    throw ConfigurationError(path + ": " + problem.what());
  } catch (const JsonError& error) {
    throw ConfigurationError(std::string(error.what()) + "; " + written);
  }
  if (!map.is_object()) throw ConfigurationError(path + ": is no JSON map; " + written);
  return map;
}

}  // namespace

json readCheck(const std::string& path) {
  const std::string written = "bin/gap check ANSWER RUNS --json FILE writes one";
  json check = readMap(path, "a check", written);
  const auto isNumber = [](const json& map, const char* key) {
    return map.contains(key) && map[key].is_number();
  };
  if (!isNumber(check, "closed") || !check.contains("runs") || !check["runs"].is_array())
    throw ConfigurationError(path + ": has no number 'closed' or no list 'runs'; " + written);
  std::size_t i = 0;
  for (const json& run : check["runs"]) {
    const std::string name = "runs[" + std::to_string(i++) + "]";
    if (!run.is_object() || !isText(run, "folder") || !isNumber(run, "before") || !isNumber(run, "after"))
      throw ConfigurationError(path + ": " + name + " lacks 'folder', 'before' or 'after'; " + written);
  }
  return check;
}

json readAnswer(const std::string& path) {
  json answer = readMap(path, "an answer", "bin/gap diagnose RUNS --json FILE writes an answer");
  if (!isText(answer, "verdict")) refuse(path, "has no 'verdict'");
  const std::string verdict = answer["verdict"];
  if (verdict != "none" && verdict != "effect" && verdict != "unknown")
    refuse(path, "has the verdict '" + verdict.substr(0, 40) + "'; it must be none, effect or unknown");
  if (!answer.contains("effects") || !answer["effects"].is_array()) refuse(path, "has no list 'effects'");
  std::size_t i = 0;
  for (const json& cause : answer["effects"]) {
    const std::string name = "effects[" + std::to_string(i++) + "]";
    checkPlace(path, cause, name);
    if (!cause.contains("value") || !cause["value"].is_number())
      refuse(path, name + " has no number as 'value'");
    if (!cause.contains("confounded_with")) continue;
    if (!cause["confounded_with"].is_array()) refuse(path, name + ".confounded_with is no list");
    for (const json& rival : cause["confounded_with"]) checkPlace(path, rival, name + ".confounded_with");
  }
  return answer;
}

}  // namespace plumbline::gap
