#include "gap/run/RecordingImport.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "framework/NearestName.h"
#include "gap/run/ColumnStatistics.h"
#include "gap/run/ImportUnits.h"
#include "gap/run/OtherTables.h"
#include "math/Median.h"

namespace plumbline::gap {
namespace {

/// In JSON lines and bags the elements of a list are columns `NAME.0`, ...; a map may call them `NAME[0]`.
std::string withDots(const std::string& from) {
  const std::size_t open = from.rfind('[');
  if (open == std::string::npos || from.back() != ']') return "";
  return from.substr(0, open) + "." + from.substr(open + 1, from.size() - open - 2);
}

}  // namespace

RecordingImport::RecordingImport(const ImportMap& map, const RecordingMap& part, std::string recording,
                                 std::function<const Mechanism*()> robot)
    : map_(map), part_(part), recording_(std::move(recording)), robot_(std::move(robot)) {
  channels_.file = recording_;
  channels_.within = part.within;
  std::error_code error;
  isBag_ = std::filesystem::is_directory(recording_, error) ||
           std::filesystem::path(recording_).extension() == ".db3";
}

void RecordingImport::requireOthers(const TimedChannels& other) {
  for (const auto& [name, column] : other.channels) taken_.insert(name);
}

void RecordingImport::run(ImportedRun& result) {
  table_ = readRecording(recording_, part_.form);
  for (const std::string& note : table_.notes) result.notes.push_back(recording_ + ": " + note);
  takeTime(result);
  for (const ColumnRule& rule : part_.rules) collect(rule);
  if (sources_.empty()) throw RunError(recording_ + ": no channel came out of it; see columns in the map");
  guessUnits(result);
  listUnused(result);
}

const std::vector<double>& RecordingImport::column(const ConfigSection& entry, const std::string& name) {
  const std::string where = map_.severalTables ? " (recordings are in the order of tables)" : "";
  auto it = std::ranges::find(table_.names, name);
  if (it == table_.names.end())
    if (const std::string other = withDots(name); !other.empty()) it = std::ranges::find(table_.names, other);
  if (const auto list = table_.lists.find(name); it == table_.names.end() && list != table_.lists.end())
    entry.fail("from", "is \"" + name + "\", whose cells hold lists of " + std::to_string(list->second) +
                           "; choose one, as " + name + "[0]");
  if (it == table_.names.end())
    entry.fail("from", "is \"" + name + "\", which " + recording_ + " has no column of" +
                           suggestion(name, table_.names) + where);
  if (const auto bad = table_.bad.find(*it); bad != table_.bad.end()) {
    const std::string list = it->substr(0, it->rfind('['));
    const auto length = table_.lists.find(list);
    throw RunError(
        recording_ + ":" + std::to_string(bad->second.line) + ": column " +
        (length == table_.lists.end() ? *it : list) + " holds \"" + bad->second.text + "\", no " +
        (length == table_.lists.end() ? "number" : "list of " + std::to_string(length->second) + " numbers") +
        "; words for lost samples go under missing in the map");
  }
  used_.insert(*it);
  return table_.columns[static_cast<std::size_t>(it - table_.names.begin())];
}

void RecordingImport::takeTime(ImportedRun& result) {
  const std::string& name = part_.timeFrom;
  const std::vector<double>& raw = column(part_.time, name);
  for (std::size_t i = 0; i < raw.size(); ++i)
    if (!std::isnan(raw[i])) kept_.push_back(i);
  result.linesWithoutTime += raw.size() - kept_.size();
  if (kept_.size() < 2) throw RunError(recording_ + ": column " + name + " holds fewer than two times");
  double last = raw[kept_[0]];
  std::vector<double> steps;
  for (std::size_t k = 1; k < kept_.size(); ++k) {
    const double now = raw[kept_[k]];
    if (now <= last)
      throw RunError(recording_ + ": row " + std::to_string(kept_[k] + 1) + " of data: " + name +
                     " does not grow; sort the recording, or cut it there");
    steps.push_back(now - last);
    last = now;
  }
  double factor = part_.timeFactor;
  if (!part_.timeUnitStated && !isBag_) {
    const Mechanism* robot = map_.head.rateHz > 0 ? nullptr : robot_();
    const double rate = map_.head.rateHz > 0 ? map_.head.rateHz : robot ? robot->controlHz : 100;
    try {
      const GuessedUnit guess = guessTimeUnit(upperMedian(std::move(steps), NAN), rate);
      factor = *importUnit(guess.unit);
      result.guesses.push_back(recording_ + ": " + name + " is taken as " + guess.unit + ": " + guess.why);
    } catch (const UnclearUnit& unclear) {
      part_.time.fail("from", "has no unit; " + name + " " + unclear.what());
    }
  }
  // The first time apart, since stamps of today in ns are larger than a double holds exactly. One recording
  // begins at 0.
  const double begin = map_.severalTables ? raw[kept_[0]] * factor + part_.timeOffset : 0;
  for (const std::size_t i : kept_) {
    const double t = begin + (raw[i] - raw[kept_[0]]) * factor;
    if (!std::isfinite(t) || (!channels_.t.empty() && t <= channels_.t.back()))
      throw RunError(recording_ + ": row " + std::to_string(i + 1) + " of data: " + name +
                     " does not grow in seconds; correct its unit");
    channels_.t.push_back(t);
  }
}

void RecordingImport::collect(const ColumnRule& rule) {
  if (rule.from.find('*') == std::string::npos) return add(rule, rule.to, rule.from);
  if (collectStar(rule, rule.from)) return;
  const std::string other = withDots(rule.from);
  if (!other.empty() && collectStar(rule, other)) return;
  rule.entry.fail("from", "is \"" + rule.from + "\", which no column of " + recording_ + " fits");
}

bool RecordingImport::collectStar(const ColumnRule& rule, const std::string& from) {
  const std::size_t star = from.find('*');
  const std::string head = from.substr(0, star), tail = from.substr(star + 1);
  bool any = false;
  for (const std::string& name : table_.names) {
    if (name.size() < head.size() + tail.size() || !name.starts_with(head) || !name.ends_with(tail)) continue;
    std::string joint = name.substr(head.size(), name.size() - head.size() - tail.size());
    if (const auto it = map_.jointOf.find(joint); it != map_.jointOf.end()) joint = it->second;
    std::string to = rule.to;
    to.replace(to.find('*'), 1, joint);
    if (!parseChannel(to) || to == "t")
      rule.entry.fail("to", "gives \"" + to + "\" for column " + name + ", which is no channel");
    add(rule, to, name);
    any = true;
  }
  return any;
}

void RecordingImport::add(const ColumnRule& rule, const std::string& to, const std::string& from) {
  const std::vector<double>& raw = column(rule.entry, from);
  if (taken_.count(to) || std::ranges::find(sources_, to, &Source::to) != sources_.end())
    rule.entry.fail("to", "gives " + to + " a second time");
  Source source{to, from, &rule, {}};
  for (const std::size_t i : kept_) source.values.push_back(raw[i]);
  sources_.push_back(std::move(source));
}

void RecordingImport::put(const Source& source, double unit) {
  std::vector<double>& channel = channels_.channels[source.to];
  for (const double x : source.values) {
    channel.push_back(unit * source.rule->factor * x + source.rule->offset);
    if (std::isinf(channel.back()))
      throw RunError(recording_ + ": column " + source.from + " holds " + shownNumber(x) +
                     ", too large for its scale; correct scale or offset in the map");
  }
}

bool RecordingImport::slides(const std::string& channel) const {
  const ChannelName name = *parseChannel(channel);
  if (!name.ofJoint()) return false;
  const Mechanism* robot = robot_();
  const int joint = robot ? robot->jointIndex(name.place) : -1;
  return joint >= 0 &&
         robot->joints[static_cast<std::size_t>(joint)].type == Mechanism::Joint::Type::prismatic;
}

void RecordingImport::guessUnits(ImportedRun& result) {
  const auto isKnown = [&](const Source& source) {
    return source.rule->unitStated || isBag_ || !UnitGuess::guesses(parseChannel(source.to)->kind);
  };
  for (const Source& source : sources_)
    if (isKnown(source)) put(source, 1);
  if (std::ranges::all_of(sources_, isKnown)) return;
  UnitGuess::Known known{&channels_.t, channels_.channels, map_.head.unsignedKinds, map_.head.freeBase};
  struct Group {
    ChannelKind kind;
    bool sliding;
  };
  // Positions show the unit of speeds, and gravity that of turning.
  std::vector<Group> groups;
  for (const ChannelKind kind :
       {ChannelKind::position, ChannelKind::command, ChannelKind::velocity, ChannelKind::commandSpeed,
        ChannelKind::torque, ChannelKind::commandTorque, ChannelKind::current, ChannelKind::commandCurrent,
        ChannelKind::voltage, ChannelKind::duty, ChannelKind::stiffness, ChannelKind::acceleration,
        ChannelKind::gyro, ChannelKind::force})
    for (const bool sliding : {false, true}) groups.push_back({kind, sliding});
  // Whose unit is not clear by itself is looked at again when others are known.
  std::vector<Group> unclear;
  for (const bool last : {false, true}) {
    for (const Group& group : last ? unclear : groups) {
      std::vector<Source*> members;
      for (Source& source : sources_)
        if (!isKnown(source) && parseChannel(source.to)->kind == group.kind &&
            slides(source.to) == group.sliding)
          members.push_back(&source);
      if (members.empty()) continue;
      try {
        guessGroup(group.kind, group.sliding, members, known, result);
      } catch (const UnclearUnit& error) {
        if (last) members[0]->rule->entry.fail("from", "has no unit; " + members[0]->to + " " + error.what());
        unclear.push_back(group);
      }
    }
  }
}

void RecordingImport::guessGroup(ChannelKind kind, bool sliding, std::vector<Source*> group,
                                 UnitGuess::Known& known, ImportedRun& result) {
  std::vector<UnitGuess::Raw> raws;
  raws.reserve(group.size());
  for (const Source* source : group)
    raws.push_back(
        {parseChannel(source->to)->place, &source->values, source->rule->factor, source->rule->offset});
  const GuessedUnit guess = UnitGuess(robot_(), known).of(kind, raws, sliding);
  for (const Source* source : group) {
    put(*source, *importUnit(guess.unit));
    known.channels[source->to] = channels_.channels[source->to];
  }
  result.guesses.push_back((group.size() == 1 ? group[0]->to + " is" : std::string(prefix(kind)) + ".* are") +
                           " taken as " + guess.unit + ": " + guess.why);
}

void RecordingImport::listUnused(ImportedRun& result) const {
  for (const std::string& name : table_.names)
    if (!used_.count(name)) result.unused.push_back(map_.severalTables ? recording_ + ": " + name : name);
}

}  // namespace plumbline::gap
