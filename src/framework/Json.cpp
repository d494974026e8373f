#include "framework/Json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace plumbline {

using nlohmann::json;

json parseJson(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    throw JsonError("is larger than " + std::to_string(limits.bytes >> 20) + " MB");
  std::vector<std::set<std::string>> keys;
  const auto check = [&](int depth, json::parse_event_t event, const json& parsed) {
    const bool opens =
        event == json::parse_event_t::object_start || event == json::parse_event_t::array_start;
    if (depth + (opens ? 1 : 0) > limits.depth)
      throw JsonError("is nested deeper than " + std::to_string(limits.depth) + " levels");
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw JsonError("key \"" + parsed.get<std::string>().substr(0, 60) + "\" occurs twice in one object");
    return true;
  };
  try {
    return json::parse(text, check);
  } catch (const json::parse_error& error) {
    const auto read = std::min(error.byte, text.size());
    const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(read), '\n');
    throw JsonError("broken JSON", 1 + static_cast<std::size_t>(lines));
  } catch (const json::exception&) {
    throw JsonError("holds a number that is too large");
  }
}

json parseJson(std::string_view text, const std::string& path, const JsonLimits& limits) {
  try {
    return parseJson(text, limits);
  } catch (const JsonError& error) {
    const std::string line = error.line > 0 ? ":" + std::to_string(error.line) : "";
    throw JsonError(path + line + ": " + error.what(), error.line);
  }
}

}  // namespace plumbline
