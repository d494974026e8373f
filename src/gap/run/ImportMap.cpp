#include "gap/run/ImportMap.h"

#include <algorithm>
#include <cmath>

#include "gap/run/Channel.h"
#include "gap/run/ImportUnits.h"

namespace plumbline::gap {
namespace {

constexpr std::size_t mostTables = 32;

/// The unit that an entry states; nothing where it states none.
std::optional<double> unitOf(const ConfigSection& entry) {
  const auto name = entry.find<std::string>("unit");
  if (!name) return std::nullopt;
  if (const auto unit = importUnit(*name)) return unit;
  entry.fail("unit", "is \"" + *name + "\"; known are " + importUnitNames());
}

ColumnRule readRule(const ConfigSection& entry) {
  ColumnRule rule;
  rule.entry = entry;
  rule.to = entry.get<std::string>("to");
  rule.from = entry.get<std::string>("from");
  const auto counts = entry.find<double>("counts_per_turn", Range{1e-6, 1e9});
  const auto unit = unitOf(entry);
  const auto scale = entry.find<double>("scale");
  rule.unitStated = counts || unit || scale;
  rule.factor = unit.value_or(counts ? 2 * M_PI / *counts : 1) * scale.value_or(1) *
                entry.find<double>("sign", Range{-1, 1}).value_or(1);
  rule.offset = entry.find<double>("offset").value_or(0);
  if (rule.factor == 0 || !std::isfinite(rule.factor))
    entry.fail("scale", rule.factor == 0 ? "makes every value 0" : "makes every value infinite");
  const auto stars = [](const std::string& s) { return std::count(s.begin(), s.end(), '*'); };
  if (stars(rule.to) != stars(rule.from) || stars(rule.to) > 1)
    entry.fail("from", "needs as many * as to, one at most");
  if (stars(rule.to) == 0 && (!parseChannel(rule.to) || rule.to == "t"))
    entry.fail("to", "is \"" + rule.to + "\"; give a channel such as pos.LKneePitch");
  return rule;
}

TableForm readForm(const ConfigSection& section, const TableForm& fallback) {
  TableForm form = fallback;
  if (const auto separator = section.find<std::string>("separator")) {
    if ((separator->size() != 1 && *separator != "tab") || *separator == "\"")
      section.fail("separator", "is \"" + *separator + "\"; give one character or tab");
    form.separator = *separator == "tab" ? '\t' : separator->front();
  }
  form.missing = section.find<std::vector<std::string>>("missing").value_or(form.missing);
  return form;
}

/// The keys time and columns, at the top of a map or in an entry of `tables`.
RecordingMap readRecordingMap(const ConfigSection& section, const TableForm& form, bool oneOfSeveral) {
  RecordingMap map;
  map.form = form;
  for (const ConfigSection& entry : section.list("columns")) map.rules.push_back(readRule(entry));
  map.time = section.section("time");
  map.timeFrom = map.time.get<std::string>("from");
  const auto unit = unitOf(map.time);
  const auto scale = map.time.find<double>("scale");
  map.timeUnitStated = unit || scale;
  map.timeFactor = unit.value_or(1) * scale.value_or(1);
  if (!(map.timeFactor > 0) || !std::isfinite(map.timeFactor)) map.time.fail("scale", "is not above 0");
  if (oneOfSeveral) {
    map.timeOffset = map.time.find<double>("offset", Range{-1e11, 1e11}).value_or(0);
    map.within = map.time.find<double>("within", Range{0, 1e3});
  }
  return map;
}

void readServo(const ConfigSection& entry, ServoOverride& servo) {
  const Range positive{0, 1e9};
  servo.kp = entry.find<double>("kp", positive);
  servo.kd = entry.find<double>("kd", positive);
  servo.armature = entry.find<double>("armature", positive);
  servo.maxTorque = entry.find<double>("max_torque", positive);
  servo.maxSpeed = entry.find<double>("max_speed", positive);
  servo.kpFirmware = entry.find<double>("kp_firmware", positive);
  servo.vin = entry.find<double>("vin", positive);
}

void readHead(const ConfigSection& root, ImportMap& map) {
  Run& r = map.head;
  r.robot = root.get<std::string>("robot");
  r.freeBase = root.choice("base", {"fixed", "free"}) == 1;
  r.motion = root.get<std::string>("motion");
  r.rateHz = root.find<double>("rate_hz", Range{1e-3, 20000}).value_or(0);
  r.heading = root.find<double>("heading", Range{-100, 100});
  if (root.has("hold")) r.linearCommands = root.choice("hold", {"zero", "linear"}) == 1;
  r.repeatOf = root.find<std::string>("repeat_of").value_or("");
  for (const std::string& kind :
       root.find<std::vector<std::string>>("unsigned").value_or(std::vector<std::string>{}))
    r.unsignedKinds.insert(kind);
  map.timingStated = root.has("timing");
  if (map.timingStated) {
    const ConfigSection timing = root.section("timing");
    const Range second{-1, 1};
    JointTiming& all = r.timing["*"];
    for (const auto& [key, field] : timingKeys) all.*field = timing.find<double>(key, second).value_or(0);
  }
  if (root.has("servo")) {
    const ConfigSection servo = root.section("servo");
    for (const std::string& joint : servo.keys()) readServo(servo.section(joint), r.servo[joint]);
  }
  if (root.has("rename")) {
    const ConfigSection rename = root.section("rename");
    std::map<std::string, std::string> recordedName;
    for (const std::string& joint : rename.keys()) recordedName[joint] = rename.get<std::string>(joint);
    for (const auto& [joint, name] : recordedName) map.jointOf[name] = joint;
  }
}

}  // namespace

ImportMap readImportMap(const std::string& path) {
  ImportMap map{ConfigFile(path), {}, {}, false, false, {}};
  const ConfigSection& root = map.file.root();
  readHead(root, map);
  const TableForm form = readForm(root, {',', {"nan", "NaN", "null"}, true, true});
  map.severalTables = root.has("tables");
  if (map.severalTables) {
    for (const char* key : {"columns", "time"})
      if (root.has(key)) root.fail(key, "is not allowed next to tables; move it into an entry of tables");
    const std::vector<ConfigSection> entries = root.list("tables");
    if (entries.empty() || entries.size() > mostTables)
      root.fail("tables", "has " + std::to_string(entries.size()) +
                              " entries; give one for each file, up to " + std::to_string(mostTables));
    for (const ConfigSection& entry : entries)
      map.recordings.push_back(readRecordingMap(entry, readForm(entry, form), true));
  } else {
    map.recordings.push_back(readRecordingMap(root, form, false));
  }
  map.file.checkUnknown();
  return map;
}

}  // namespace plumbline::gap
