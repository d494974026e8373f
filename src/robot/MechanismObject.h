#pragma once
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "framework/NearestName.h"
#include "robot/MechanismParts.h"

namespace plumbline {

/// One object of a robot's JSON file, with its place for error texts.
class MechanismObject {
public:
  /// at: for people, `joint Knee`; steps: its place in the file, `joints[3]`.
  MechanismObject(const nlohmann::json& value, std::string at, std::string steps, const std::string& file)
      : value(value), place(std::move(at)), path(std::move(steps)), file(file) {
    if (!value.is_object())
      failMechanism(file, (place.empty() ? "it" : place) + " is no object; write { ... }");
  }

  [[noreturn]] void fail(const std::string& what) const {
    failMechanism(file, place.empty() ? what : place + ": " + what);
  }

  /// Refuses all keys but these.
  void only(const std::vector<std::string>& known) const {
    for (const auto& [key, unused] : value.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        failMechanism(file, (path.empty() ? "" : path + ".") + key.substr(0, 60) + ": unknown key" +
                                suggestion(key, known));
  }

  bool has(const char* key) const { return value.contains(key) && !value[key].is_null(); }

  const nlohmann::json& at(const char* key, const char* hint) const {
    if (!has(key)) fail(std::string(key) + " is missing; give " + hint);
    return value[key];
  }

  double number(const char* key, const char* hint) const { return toNumber(at(key, hint), key); }
  double number(const char* key, double fallback) const {
    return has(key) ? toNumber(value[key], key) : fallback;
  }

  double atLeast(double lowest, const char* key, const char* hint) const {
    const double x = number(key, hint);
    if (x < lowest) fail(std::string(key) + " is " + numberText(x) + "; give " + hint);
    return x;
  }

  double positive(const char* key, const char* hint) const {
    const double x = number(key, hint);
    if (!(x > 0)) fail(std::string(key) + " is " + numberText(x) + "; give " + hint);
    return x;
  }

  bool flag(const char* key) const {
    if (!has(key)) return false;
    if (!value[key].is_boolean())
      fail(std::string(key) + " is " + shown(value[key]) + "; give true or false");
    return value[key].get<bool>();
  }

  std::string text(const char* key, const char* hint) const {
    const nlohmann::json& v = at(key, hint);
    if (!v.is_string()) fail(std::string(key) + " is " + shown(v) + "; give " + hint);
    return v.get<std::string>();
  }

  template <int n>
  Eigen::Matrix<double, n, 1> vector(const char* key, const char* hint) const {
    const nlohmann::json& v = at(key, hint);
    if (!v.is_array() || v.size() != n) fail(std::string(key) + " is " + shown(v) + "; give " + hint);
    Eigen::Matrix<double, n, 1> result;
    for (int i = 0; i < n; ++i) result[i] = toNumber(v[static_cast<std::size_t>(i)], key);
    return result;
  }

  Vec3 vector3(const char* key, const Vec3& fallback) const {
    return has(key) ? Vec3(vector<3>(key, "three numbers")) : fallback;
  }

  MechanismObject child(const char* key, const char* hint) const {
    return {at(key, hint), place.empty() ? key : place + ": " + key, path.empty() ? key : path + "." + key,
            file};
  }

  const nlohmann::json& value;
  const std::string place, path;
  const std::string& file;

private:
  static std::string shown(const nlohmann::json& v) {
    if (v.is_array()) return "a list of " + std::to_string(v.size());
    if (v.is_object()) return "an object";
    std::string text = v.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    if (text.size() > 40) text = text.substr(0, 40) + "...";
    return text;
  }

  double toNumber(const nlohmann::json& v, const char* key) const {
    if (!v.is_number()) fail(std::string(key) + " is " + shown(v) + ", no number");
    const double x = v.get<double>();
    if (!(std::abs(x) < 1e12)) fail(std::string(key) + " is " + numberText(x) + "; that is too large");
    return x;
  }
};

}  // namespace plumbline
