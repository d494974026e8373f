#include "gap/run/RunImport.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "framework/ConfigFile.h"
#include "framework/NearestName.h"
#include "gap/run/ColumnStatistics.h"
#include "gap/run/OtherTables.h"

namespace plumbline::gap {
namespace {

constexpr double standardGravity = 9.80665;

/// What one of the unit is in the run's unit.
const std::map<std::string, double>& units() {
  static const std::map<std::string, double> table = {{"1", 1},
                                                      {"rad", 1},
                                                      {"deg", M_PI / 180},
                                                      {"turn", 2 * M_PI},
                                                      {"rad/s", 1},
                                                      {"deg/s", M_PI / 180},
                                                      {"rpm", M_PI / 30},
                                                      {"m", 1},
                                                      {"mm", 1e-3},
                                                      {"m/s^2", 1},
                                                      {"g", standardGravity},
                                                      {"N", 1},
                                                      {"kgf", standardGravity},
                                                      {"Nm", 1},
                                                      {"mNm", 1e-3},
                                                      {"A", 1},
                                                      {"mA", 1e-3},
                                                      {"V", 1},
                                                      {"mV", 1e-3},
                                                      {"percent", 1e-2},
                                                      {"s", 1},
                                                      {"ms", 1e-3},
                                                      {"us", 1e-6},
                                                      {"ns", 1e-9},
                                                      {"C", 1}};
  return table;
}

double unitOf(const ConfigSection& entry, double otherwise) {
  const auto name = entry.find<std::string>("unit");
  if (!name) return otherwise;
  const auto it = units().find(*name);
  if (it != units().end()) return it->second;
  std::string list;
  for (const auto& [unit, factor] : units()) list += (list.empty() ? "" : " ") + unit;
  entry.fail("unit", "is \"" + *name + "\"; known are " + list);
}

/// One line of `columns`.
struct Rule {
  std::string to, from;
  double factor = 1, offset = 0;
  ConfigSection entry;
};

Rule readRule(const ConfigSection& entry) {
  Rule rule;
  rule.entry = entry;
  rule.to = entry.get<std::string>("to");
  rule.from = entry.get<std::string>("from");
  const auto counts = entry.find<double>("counts_per_turn", Range{1e-6, 1e9});
  rule.factor = unitOf(entry, counts ? 2 * M_PI / *counts : 1) * entry.find<double>("scale").value_or(1) *
                entry.find<double>("sign", Range{-1, 1}).value_or(1);
  rule.offset = entry.find<double>("offset").value_or(0);
  if (rule.factor == 0) entry.fail("scale", "makes every value 0");
  const auto stars = [](const std::string& s) { return std::count(s.begin(), s.end(), '*'); };
  if (stars(rule.to) != stars(rule.from) || stars(rule.to) > 1)
    entry.fail("from", "needs as many * as to, one at most");
  if (stars(rule.to) == 0 && (!parseChannel(rule.to) || rule.to == "t"))
    entry.fail("to", "is \"" + rule.to + "\"; give a channel such as pos.LKneePitch");
  return rule;
}

class Importer {
public:
  Importer(const std::string& mapFile, const std::string& recording)
      : map_(mapFile), root_(map_.root()), recording_(recording) {}

  ImportedRun run() {
    readHead();
    const std::string separator = root_.find<std::string>("separator").value_or(",");
    if (separator.size() != 1 && separator != "tab")
      root_.fail("separator", "is \"" + separator + "\"; give one character or tab");
    const auto missing = root_.find<std::vector<std::string>>("missing").value_or(
        std::vector<std::string>{"nan", "NaN", "null"});
    rules_ = root_.list("columns");
    std::vector<Rule> parsed;
    for (const ConfigSection& entry : rules_) parsed.push_back(readRule(entry));
    const ConfigSection time = root_.section("time");
    const std::string timeColumn = time.get<std::string>("from");
    const double timeFactor = unitOf(time, 1) * time.find<double>("scale").value_or(1);
    if (!(timeFactor > 0)) time.fail("scale", "is not above 0");
    map_.checkUnknown();

    table_ = readRecording(recording_, separator == "tab" ? '\t' : separator[0], missing);
    takeTime(time, timeColumn, timeFactor);
    for (const Rule& rule : parsed) apply(rule);
    if (result_.run.channels.empty())
      throw RunError(recording_ + ": no channel came out of it; see columns in the map");
    if (result_.run.rateHz == 0) result_.run.rateHz = std::round(1e4 / medianStep(result_.run.t)) / 1e4;
    for (const std::string& name : table_.names)
      if (!used_.count(name)) result_.unused.push_back(name);
    return std::move(result_);
  }

private:
  void readHead() {
    Run& r = result_.run;
    r.folder = recording_;
    r.robot = root_.get<std::string>("robot");
    r.freeBase = root_.choice("base", {"fixed", "free"}) == 1;
    r.motion = root_.get<std::string>("motion");
    r.rateHz = root_.find<double>("rate_hz", Range{1e-3, 20000}).value_or(0);
    r.heading = root_.find<double>("heading", Range{-100, 100});
    if (root_.has("hold")) r.linearCommands = root_.choice("hold", {"zero", "linear"}) == 1;
    r.repeatOf = root_.find<std::string>("repeat_of").value_or("");
    for (const std::string& kind :
         root_.find<std::vector<std::string>>("unsigned").value_or(std::vector<std::string>{}))
      r.unsignedKinds.insert(kind);
    if (root_.has("timing")) {
      const ConfigSection timing = root_.section("timing");
      const Range second{-1, 1};
      r.timing["*"] = {timing.find<double>("cmd_at_s", second).value_or(0),
                       timing.find<double>("pos_at_s", second).value_or(0),
                       timing.find<double>("vel_at_s", second).value_or(0)};
    }
    if (root_.has("servo")) {
      const ConfigSection servo = root_.section("servo");
      for (const std::string& joint : servo.keys()) readServo(servo.section(joint), r.servo[joint]);
    }
    if (root_.has("rename")) {
      const ConfigSection rename = root_.section("rename");
      for (const std::string& joint : rename.keys()) recordedName_[joint] = rename.get<std::string>(joint);
      for (const auto& [joint, name] : recordedName_) jointOf_[name] = joint;
    }
  }

  static void readServo(const ConfigSection& entry, ServoOverride& servo) {
    const Range positive{0, 1e9};
    servo.kp = entry.find<double>("kp", positive);
    servo.kd = entry.find<double>("kd", positive);
    servo.armature = entry.find<double>("armature", positive);
    servo.maxTorque = entry.find<double>("max_torque", positive);
    servo.maxSpeed = entry.find<double>("max_speed", positive);
    servo.kpFirmware = entry.find<double>("kp_firmware", positive);
    servo.vin = entry.find<double>("vin", positive);
  }

  const std::vector<double>& column(const ConfigSection& entry, const std::string& name) {
    const auto it = std::find(table_.names.begin(), table_.names.end(), name);
    if (it == table_.names.end())
      entry.fail("from", "is \"" + name + "\", which " + recording_ + " has no column of" +
                             suggestion(name, table_.names));
    if (const auto bad = table_.bad.find(name); bad != table_.bad.end())
      throw RunError(recording_ + ":" + std::to_string(bad->second.line) + ": column " + name + " holds \"" +
                     bad->second.text + "\", no number; words for lost samples go under missing in the map");
    used_.insert(name);
    return table_.columns[static_cast<std::size_t>(it - table_.names.begin())];
  }

  void takeTime(const ConfigSection& time, const std::string& name, double factor) {
    const std::vector<double>& raw = column(time, name);
    for (std::size_t i = 0; i < raw.size(); ++i)
      if (!std::isnan(raw[i])) kept_.push_back(i);
    result_.linesWithoutTime = raw.size() - kept_.size();
    if (kept_.size() < 2) throw RunError(recording_ + ": column " + name + " holds fewer than two times");
    for (const std::size_t i : kept_) {
      const double t = (raw[i] - raw[kept_[0]]) * factor;
      if (!result_.run.t.empty() && t <= result_.run.t.back())
        throw RunError(recording_ + ": row " + std::to_string(i + 1) + " of data: " + name +
                       " does not grow; sort the recording, or cut it there");
      result_.run.t.push_back(t);
    }
  }

  void apply(const Rule& rule) {
    const std::size_t star = rule.from.find('*');
    if (star == std::string::npos) {
      add(rule, rule.to, rule.from);
      return;
    }
    const std::string head = rule.from.substr(0, star), tail = rule.from.substr(star + 1);
    bool any = false;
    for (const std::string& name : table_.names) {
      if (name.size() < head.size() + tail.size() || name.compare(0, head.size(), head) != 0 ||
          name.compare(name.size() - tail.size(), tail.size(), tail) != 0)
        continue;
      std::string joint = name.substr(head.size(), name.size() - head.size() - tail.size());
      if (const auto it = jointOf_.find(joint); it != jointOf_.end()) joint = it->second;
      std::string to = rule.to;
      to.replace(to.find('*'), 1, joint);
      if (!parseChannel(to))
        rule.entry.fail("to", "gives \"" + to + "\" for column " + name + ", which is no channel");
      add(rule, to, name);
      any = true;
    }
    if (!any) rule.entry.fail("from", "is \"" + rule.from + "\", which no column of " + recording_ + " fits");
  }

  void add(const Rule& rule, const std::string& to, const std::string& from) {
    const std::vector<double>& raw = column(rule.entry, from);
    if (result_.run.channels.count(to)) rule.entry.fail("to", "gives " + to + " a second time");
    std::vector<double>& channel = result_.run.channels[to];
    for (const std::size_t i : kept_) channel.push_back(rule.factor * raw[i] + rule.offset);
  }

  ConfigFile map_;
  ConfigSection root_;
  const std::string recording_;
  std::vector<ConfigSection> rules_;
  std::map<std::string, std::string> recordedName_, jointOf_;
  Table table_;
  std::vector<std::size_t> kept_;
  std::set<std::string> used_;
  ImportedRun result_;
};

}  // namespace

ImportedRun importRecording(const std::string& mapFile, const std::string& recording) {
  return Importer(mapFile, recording).run();
}

}  // namespace plumbline::gap
