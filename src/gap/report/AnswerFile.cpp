#include "gap/report/AnswerFile.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "framework/Json.h"

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

}  // namespace

json readAnswer(const std::string& path) {
  constexpr std::uintmax_t longest = 256ULL << 20;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw ConfigurationError(path + ": there is no such file");
  if (std::filesystem::file_size(path, error) > longest) refuse(path, "is too long for an answer");
  std::ifstream file(path, std::ios::binary);
  json answer;
  try {
    answer = parseJson(std::string(std::istreambuf_iterator<char>(file), {}), path);
  } catch (const JsonError& error) {
    throw ConfigurationError(std::string(error.what()) +
                             "; bin/gap diagnose RUNS --json FILE writes an answer");
  }
  if (!answer.is_object()) refuse(path, "is no JSON map");
  if (!isText(answer, "verdict")) refuse(path, "has no 'verdict'");
  const std::string verdict = answer["verdict"];
  if (verdict != "none" && verdict != "effect" && verdict != "unknown")
    refuse(path, "has the verdict '" + verdict.substr(0, 40) + "'; there is none, effect, unknown");
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
