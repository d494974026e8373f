#include "gap/run/RunFile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "framework/Json.h"
#include "framework/NearestName.h"
#include "framework/ReadFile.h"
#include "gap/run/Table.h"

namespace plumbline::gap {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t maxJsonSize = 1 << 20;

std::string shown(const json& value) {
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

/// run.json with errors that name file and key.
class Meta {
public:
  explicit Meta(const std::string& path) : path_(path) {
    std::string text;
    try {
      text = readFile(path_, maxJsonSize);
    } catch (const FileProblem& problem) {
      fail(problem.what());
    }
    try {
      value = parseJson(text, path_);
    } catch (const JsonError& error) {
      throw RunError(error.what());
    }
    if (!value.is_object()) fail("is no object; write { ... }");
  }

  [[noreturn]] void fail(const std::string& what) const { throw RunError(path_ + ": " + what); }

  const json* find(const json& object, const char* key) const {
    const auto it = object.find(key);
    return it == object.end() || it->is_null() ? nullptr : &*it;
  }
  const json* find(const char* key) const { return find(value, key); }

  const json& at(const char* key, const char* hint) const {
    const json* found = find(key);
    if (!found) fail(std::string(key) + " is missing; give " + hint);
    return *found;
  }

  std::string text(const char* key, const char* hint) const {
    const json& v = at(key, hint);
    if (!v.is_string() || v.get<std::string>().size() > 2000)
      fail(std::string(key) + " is " + shown(v) + "; give " + hint);
    return v.get<std::string>();
  }

  /// Every key of an object is one of those; `of`: the object's own key with a dot, empty for the whole.
  void only(const json& object, const std::string& of, const std::vector<std::string>& keys) const {
    for (const auto& [key, v] : object.items())
      if (std::ranges::find(keys, key) == keys.end())
        fail("there is no key " + of + key.substr(0, 60) + suggestion(key, keys));
  }

  double number(const json& v, const std::string& key, double low, double high) const {
    if (!v.is_number()) fail(key + " is " + shown(v) + "; give a number");
    const double x = v.get<double>();
    if (!(x >= low && x <= high))
      fail(key + " is " + shown(v) + ", outside " + text(low) + " to " + text(high));
    return x;
  }

  json value;

private:
  static std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", x);
    return buffer;
  }

  const std::string path_;
};

void readServo(const Meta& meta, Run& run) {
  const json* servo = meta.find("servo");
  if (!servo) return;
  if (!servo->is_object()) meta.fail("servo is " + shown(*servo) + "; give { JOINT: {kp, kd}, ... }");
  for (const auto& [joint, given] : servo->items()) {
    const std::string place = "servo." + joint.substr(0, 80);
    if (!given.is_object()) meta.fail(place + " is " + shown(given) + "; give {kp, kd}");
    meta.only(given, place + ".",
              {"kp", "kd", "armature", "max_torque", "max_speed", "dc_motor", "kp_firmware", "vin"});
    ServoOverride& target = run.servo[joint];
    const auto read = [&](const json& from, const char* key, std::optional<double>& x) {
      if (const json* v = meta.find(from, key)) x = meta.number(*v, place + "." + key, 0, 1e9);
    };
    read(given, "kp", target.kp);
    read(given, "kd", target.kd);
    read(given, "armature", target.armature);
    read(given, "max_torque", target.maxTorque);
    read(given, "max_speed", target.maxSpeed);
    const json* motor = meta.find(given, "dc_motor");
    if (motor && !motor->is_object())
      meta.fail(place + ".dc_motor is " + shown(*motor) + "; give {kp_firmware, vin}");
    if (motor) meta.only(*motor, place + ".dc_motor.", {"kp_firmware", "vin"});
    for (const json* from : {&given, motor}) {
      if (!from) continue;
      read(*from, "kp_firmware", target.kpFirmware);
      read(*from, "vin", target.vin);
    }
  }
}

void readTiming(const Meta& meta, Run& run) {
  const json* timing = meta.find("timing");
  if (!timing) return;
  if (!timing->is_object())
    meta.fail("timing is " + shown(*timing) + "; give {cmd_at_s, pos_at_s, vel_at_s, effort_at_s}");
  std::vector<std::string> known;
  for (const auto& [key, field] : timingKeys) known.emplace_back(key);
  known.emplace_back("note");
  meta.only(*timing, "timing.", known);
  // One number for all first, so that a joint's own entry starts from it.
  for (const auto& [key, field] : timingKeys) {
    const json* v = meta.find(*timing, key);
    if (v && !v->is_object()) run.timing["*"].*field = meta.number(*v, std::string("timing.") + key, -1, 1);
  }
  const JointTiming all = run.timingOf("*");
  for (const auto& [key, field] : timingKeys) {
    const json* v = meta.find(*timing, key);
    if (!v || !v->is_object()) continue;
    for (const auto& [joint, seconds] : v->items())
      run.timing.try_emplace(joint, all).first->second.*field =
          meta.number(seconds, std::string("timing.") + key + "." + joint.substr(0, 80), -1, 1);
  }
}

void readMeta(const std::string& path, Run& run) {
  const Meta meta(path);
  meta.only(meta.value, "",
            {"robot", "base", "rate_hz", "motion", "ground_truth", "servo", "repeat_of", "repeat", "heading",
             "unsigned", "timing", "hold", "source", "session", "rig", "note"});
  run.robot = meta.text("robot", "the robot's name");
  if (run.robot.empty() || run.robot.find('/') != std::string::npos)
    meta.fail("robot is " + shown(run.robot) + "; give the robot's name");
  const std::string base = meta.text("base", "\"fixed\" or \"free\"");
  if (base != "fixed" && base != "free") meta.fail("base is " + shown(base) + "; give \"fixed\" or \"free\"");
  run.freeBase = base == "free";
  run.rateHz = meta.number(meta.at("rate_hz", "cycles per second"), "rate_hz", 1e-3, 20000);
  run.motion = meta.text("motion", "what was played");
  const json& truth = meta.at("ground_truth", "true or false");
  if (!truth.is_boolean()) meta.fail("ground_truth is " + shown(truth) + "; give true or false");
  run.groundTruth = truth.get<bool>();
  for (const char* key : {"repeat_of", "repeat"})
    if (run.repeatOf.empty() && meta.find(key)) run.repeatOf = meta.text(key, "the name of another run");
  if (const json* heading = meta.find("heading")) run.heading = meta.number(*heading, "heading", -100, 100);
  if (meta.find("hold")) {
    const std::string hold = meta.text("hold", "\"zero\" or \"linear\"");
    if (hold != "zero" && hold != "linear")
      meta.fail("hold is " + shown(hold) + "; give \"zero\" or \"linear\"");
    run.linearCommands = hold == "linear";
  }
  if (const json* list = meta.find("unsigned")) {
    if (!list->is_array()) meta.fail("unsigned is " + shown(*list) + "; give a list of channels");
    for (const json& v : *list) {
      if (!v.is_string()) meta.fail("unsigned holds " + shown(v) + "; give a list of channels");
      run.unsignedKinds.insert(v.get<std::string>());
    }
  }
  readServo(meta, run);
  readTiming(meta, run);
}

std::string findTable(const std::string& folder) {
  const std::string plain = (fs::path(folder) / "run.csv").string(), packed = plain + ".gz";
  std::error_code error;
  const bool hasPlain = fs::exists(plain, error), hasPacked = fs::exists(packed, error);
  if (hasPlain && hasPacked) throw RunError(folder + ": holds both run.csv and run.csv.gz; remove one");
  if (!hasPlain && !hasPacked) throw RunError(folder + ": holds no run.csv and no run.csv.gz");
  return hasPlain ? plain : packed;
}

void takeTime(const std::string& path, Table& table, Run& run) {
  const auto it = std::find(table.names.begin(), table.names.end(), "t");
  if (it == table.names.end()) throw RunError(path + ": has no column t; give the time of each line in s");
  if (const auto bad = table.bad.find("t"); bad != table.bad.end())
    throw RunError(path + ":" + std::to_string(bad->second.line) + ": t is \"" + bad->second.text +
                   "\", no number");
  run.t = std::move(table.columns[static_cast<std::size_t>(it - table.names.begin())]);
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    const std::string where = path + ": row " + std::to_string(i + 1) + " of data: t ";
    if (std::isnan(run.t[i])) throw RunError(where + "is empty; give every line its time");
    if (i > 0 && run.t[i] <= run.t[i - 1])
      throw RunError(where + "is " + shown(run.t[i]) + " after " + shown(run.t[i - 1]) + "; time must grow");
  }
}

}  // namespace

Run readRun(const std::string& folder, std::vector<RunWarning>& warnings) {
  Run run;
  run.folder = folder;
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw RunError(folder + ": is no folder; a run is a folder with run.json and run.csv");
  readMeta((fs::path(folder) / "run.json").string(), run);
  const std::string path = findTable(folder);
  Table table = readTable(path);
  takeTime(path, table, run);
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const std::string& name = table.names[c];
    if (name == "t") continue;
    const std::vector<double>& column = table.columns[c];
    if (const auto bad = table.bad.find(name); bad != table.bad.end())
      warnings.push_back({name, true,
                          "line " + std::to_string(bad->second.line) + " holds \"" + bad->second.text +
                              "\", no number; a lost sample is an empty cell"});
    else if (!parseChannel(name))
      warnings.push_back({name, true, "the format has no such column"});
    else if (std::all_of(column.begin(), column.end(), [](double x) { return std::isnan(x); }))
      warnings.push_back({name, true, "it is empty"});
    else
      run.channels.emplace(name, std::move(table.columns[c]));
  }
  return run;
}

std::vector<std::string> findRuns(const std::string& path) {
  std::error_code error;
  const auto isRun = [&](const fs::path& folder) {
    for (const char* file : {"run.json", "run.csv", "run.csv.gz"})
      if (fs::exists(folder / file, error)) return true;
    return false;
  };
  if (!fs::is_directory(path, error))
    throw RunError(path + ": is no folder; a run is a folder with run.json and run.csv");
  if (isRun(path)) return {path};
  std::vector<std::string> runs;
  constexpr int maxFolderDepth = 6;
  for (auto it = fs::recursive_directory_iterator(path, error); it != fs::recursive_directory_iterator();
       it.increment(error)) {
    if (error) break;
    if (it.depth() == maxFolderDepth) it.disable_recursion_pending();
    if (it->is_directory(error) && isRun(it->path())) runs.push_back(it->path().string());
  }
  if (runs.empty()) throw RunError(path + ": holds no run; a run is a folder with run.json and run.csv");
  std::sort(runs.begin(), runs.end());
  return runs;
}

}  // namespace plumbline::gap
