#include "motion/KeyframeText.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "framework/ConfigurationError.h"
#include "framework/YamlDocument.h"
#include "math/Angle.h"
#include "motion/KeyframeReader.h"

namespace plumbline::motion {

namespace {

constexpr std::size_t width = 110;   // of a line with new joints
constexpr double sameNumber = 5e-4;  // what three decimals cannot distinguish

std::string number(double value) {
  char digits[64];
  std::snprintf(digits, sizeof digits, "%.3f", std::fabs(value) < sameNumber ? 0 : value);
  std::string result = digits;
  result.erase(result.find_last_not_of('0') + 1);
  if (result.back() == '.') result.pop_back();
  return result;
}

bool same(double a, double b) { return std::fabs(a - b) < sameNumber; }

/// One line for one joint or for both sides.
struct Entry {
  std::string key;
  double value;
};

/// Writes both sides under one name if they are mirror images.
std::vector<Entry> entriesOf(std::map<std::string, double> degrees, const RobotModel& robot) {
  std::vector<Entry> entries;
  for (int j = 0; j < maxJoints; ++j) {
    const auto joint = static_cast<JointId>(j);
    if (!robot.has(joint)) continue;
    const auto own = degrees.find(std::string(robot.jointName(joint)));
    if (own == degrees.end()) continue;
    const JointId mirror = mirrored(joint);
    const std::string both = mirror > joint ? bothSides(robot, joint) : "";
    const auto other = both.empty() ? degrees.end() : degrees.find(std::string(robot.jointName(mirror)));
    if (other != degrees.end() && same(other->second, mirrorSign(joint) * own->second)) {
      entries.push_back({both, own->second});
      degrees.erase(other);
    } else {
      entries.push_back({own->first, own->second});
    }
  }
  return entries;
}

/// A motion's text in which pieces are replaced; places of pieces are those in the original text.
class Editor {
public:
  Editor(const std::string& text, const std::string& path, const RobotModel& robot)
      : text_(text), path_(path), robot_(robot) {
    try {
      root_ = parseYaml(text, path);
    } catch (const ConfigurationError& error) {
      throw KeyframeFileError(error.what());
    }
    if (!root_.IsMap()) fail(root_, "a motion is a map with the key keyframes");
    if (root_["mirror"])
      fail(root_["mirror"], "this is the mirror image of " +
                                root_["mirror"].as<std::string>("another motion") + "; edit that one");
    list_ = root_["keyframes"];
    if (!list_ || !list_.IsSequence() || list_.size() == 0) fail(root_, "keyframes: missing or empty");
    if (list_.Style() == YAML::EmitterStyle::Flow)
      fail(list_, "keyframes are in brackets; give each a line that begins with \"- \" to edit them");
    readBlocks();
  }

  std::string edited(const std::vector<KeyframeDraft>& keyframes) {
    std::string result = text_.substr(0, blocks_.front().begin);
    for (const KeyframeDraft& keyframe : keyframes) {
      if (keyframe.from >= static_cast<int>(blocks_.size()))
        throw KeyframeFileError(path_ + ": there is no keyframe " + std::to_string(keyframe.from));
      std::string block = keyframe.from < 0 ? indent_ + "- " + written(keyframe) + "\n"
                                            : changed(static_cast<std::size_t>(keyframe.from), keyframe);
      result += block;
      if (result.back() != '\n') result += '\n';
    }
    return result + text_.substr(blocks_.back().end);
  }

private:
  /// A keyframe's lines: comments above it, then its own.
  struct Block {
    std::size_t begin, item, end;  ///< of the comments; of the map; behind the last line
  };
  struct Change {
    std::size_t begin, end;
    std::string text;
  };

  [[noreturn]] void fail(const YAML::Node& where, const std::string& what) const {
    const int line = where.Mark().is_null() ? 1 : where.Mark().line + 1;
    throw KeyframeFileError(path_ + ":" + std::to_string(line) + ": " + what);
  }

  std::size_t lineBegin(std::size_t place) const {
    const auto before = place == 0 ? std::string::npos : text_.rfind('\n', place - 1);
    return before == std::string::npos ? 0 : before + 1;
  }
  std::size_t lineEnd(std::size_t place) const {
    const auto end = text_.find('\n', place);
    return end == std::string::npos ? text_.size() : end + 1;
  }
  static std::size_t placeOf(const YAML::Node& node) { return static_cast<std::size_t>(node.Mark().pos); }

  /// The place after the bracket that closes the one at a place.
  std::size_t closing(std::size_t open) const {
    int depth = 0;
    char quote = 0;
    for (std::size_t i = open; i < text_.size(); ++i) {
      const char c = text_[i];
      if (quote) {
        if (c == quote) quote = 0;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '#' && std::isspace(static_cast<unsigned char>(text_[i - 1]))) {
        i = lineEnd(i) - 1;
      } else if (c == '{' || c == '[') {
        ++depth;
      } else if ((c == '}' || c == ']') && --depth == 0) {
        return i + 1;
      }
    }
    return text_.size();
  }

  bool isFlow(std::size_t i) const { return list_[i].Style() == YAML::EmitterStyle::Flow; }

  void readBlocks() {
    std::size_t before = lineEnd(placeOf(list_) > 0 ? lineBegin(placeOf(list_)) - 1 : 0);
    for (std::size_t i = 0; i < list_.size(); ++i) {
      const std::size_t item = placeOf(list_[i]);
      if (!list_[i].IsMap() || lineBegin(item) < before)
        fail(list_[i], "this keyframe does not begin with \"- \" in a line of its own");
      const std::size_t end = isFlow(i) ? lineEnd(closing(item) - 1) : endOfBlockMap(i);
      blocks_.push_back({before, item, end});
      before = end;
    }
    const std::size_t first = lineBegin(blocks_.front().item);
    indent_ = text_.substr(first, text_.find_first_not_of(' ', first) - first);
    blocks_.front().begin = commentsAbove(first);
  }

  /// The first line of the comments right above a line.
  std::size_t commentsAbove(std::size_t line) const {
    while (line > 0) {
      const std::size_t above = lineBegin(line - 1);
      const std::size_t text = text_.find_first_not_of(" \t", above);
      if (text_[text] != '#') break;
      line = above;
    }
    return line;
  }

  std::size_t endOfBlockMap(std::size_t i) const {
    std::size_t last = placeOf(list_[i]);
    for (const auto& item : list_[i]) {
      last = std::max(last, placeOf(item.second));
      if (item.second.IsMap() && item.second.size() > 0)
        for (const auto& inner : item.second) last = std::max(last, placeOf(inner.second));
    }
    return lineEnd(last);
  }

  /// "{time: 0.2, LElbowRoll: -60}", in lines as long as people write them.
  std::string written(const KeyframeDraft& keyframe) const {
    std::string result = "{time: " + number(keyframe.seconds);
    if (keyframe.settleSeconds > 0) result += ", settle: " + number(keyframe.settleSeconds);
    const std::string next = "\n" + indent_ + "   ";
    std::size_t column = indent_.size() + 2 + result.size();
    for (const Entry& entry : entriesOf(keyframe.degrees, robot_)) {
      const std::string part = entry.key + ": " + number(entry.value);
      const bool wraps = column + part.size() + 2 > width;
      result += "," + (wraps ? next : " ") + part;
      column = wraps ? indent_.size() + 3 + part.size() : column + part.size() + 2;
    }
    return result + "}";
  }

  /// The new form of a key of the file's keyframe: nothing, one entry, or one for each side.
  std::vector<Entry> wanted(const std::string& key, std::map<std::string, double>& rest) const {
    std::map<std::string, double> own;
    for (const std::string& name : {key, "L" + key, "R" + key}) {
      if (robot_.joint(key).has_value() != (name == key)) continue;
      if (const auto found = rest.find(name); found != rest.end()) own.insert(rest.extract(found));
    }
    return entriesOf(own, robot_);
  }

  std::string changed(std::size_t i, const KeyframeDraft& keyframe) const {
    const Block& block = blocks_[i];
    const YAML::Node node = list_[i];
    std::vector<Change> changes;
    std::map<std::string, double> rest = keyframe.degrees;
    bool settles = false;
    for (const auto& item : node) {
      const std::string key = item.first.as<std::string>();
      const std::size_t begin = placeOf(item.first), end = endOfScalar(item.second);
      std::vector<Entry> entries;
      if (key == "ballX" || key == "ballY") continue;
      if (key == "time") {
        entries = {{key, keyframe.seconds}};
      } else if (key == "settle") {
        settles = true;
        if (keyframe.settleSeconds > 0) entries = {{key, keyframe.settleSeconds}};
      } else {
        entries = wanted(key, rest);
      }
      double was = 0;
      YAML::convert<double>::decode(item.second, was);
      if (entries.size() == 1 && entries[0].key == key) {
        if (!same(was, entries[0].value))
          changes.push_back({placeOf(item.second), end, number(entries[0].value)});
        continue;
      }
      std::string text;
      for (const Entry& entry : entries)
        text += (text.empty() ? "" : ", ") + entry.key + ": " + number(entry.value);
      changes.push_back(text.empty() ? without(begin, end) : Change{begin, end, text});
      if (!isFlow(i)) return rewritten(i, keyframe);
    }
    std::string more;
    if (keyframe.settleSeconds > 0 && !settles) more += ", settle: " + number(keyframe.settleSeconds);
    const std::size_t bracket = closing(block.item) - 1;
    const std::size_t last = text_.find_last_not_of(" \t\n", bracket - 1) + 1;
    std::size_t column = last - lineBegin(last) + more.size();
    for (const Entry& entry : entriesOf(rest, robot_)) {
      const std::string part = entry.key + ": " + number(entry.value);
      const bool wraps = column + part.size() + 2 > width;
      more += "," + (wraps ? "\n" + indent_ + "   " : " ") + part;
      column = wraps ? indent_.size() + 3 + part.size() : column + part.size() + 2;
    }
    if (!more.empty()) {
      if (!isFlow(i)) return rewritten(i, keyframe);
      changes.push_back({last, last, text_[last - 1] == ',' ? more.substr(1) : more});
    }
    return applied(block, std::move(changes));
  }

  /// With the comma and the space that go with it.
  Change without(std::size_t begin, std::size_t end) const {
    const std::size_t behind = text_.find_first_not_of(" \t", end);
    if (behind < text_.size() && text_[behind] == ',') {
      const std::size_t next = text_.find_first_not_of(" \t", behind + 1);
      return {begin, next == std::string::npos ? behind + 1 : next, ""};
    }
    const std::size_t comma = text_.find_last_not_of(" \t\n", begin - 1);
    return {text_[comma] == ',' ? comma : begin, end, ""};
  }

  std::size_t endOfScalar(const YAML::Node& value) const {
    if (!value.IsScalar()) return placeOf(value);
    const std::size_t begin = placeOf(value);
    if (text_[begin] == '"' || text_[begin] == '\'') {
      const std::size_t quote = text_.find(text_[begin], begin + 1);
      return quote == std::string::npos ? text_.size() : quote + 1;
    }
    return std::min(text_.find_first_of(",} \t\r\n", begin), text_.size());
  }

  /// A keyframe of one key a line whose keys change: in the form of new ones, below its comments.
  std::string rewritten(std::size_t i, const KeyframeDraft& keyframe) const {
    if (list_[i]["ballX"] || list_[i]["ballY"])
      fail(list_[i], "a keyframe that moves with the ball takes no other joints here; write it in braces");
    const std::size_t line = lineBegin(blocks_[i].item);
    return text_.substr(blocks_[i].begin, line - blocks_[i].begin) + indent_ + "- " + written(keyframe) +
           "\n";
  }

  std::string applied(const Block& block, std::vector<Change> changes) const {
    std::ranges::sort(changes, {}, &Change::begin);
    std::string result;
    std::size_t place = block.begin;
    for (const Change& change : changes) {
      const std::size_t begin = std::max(change.begin, place);
      result += text_.substr(place, begin - place) + change.text;
      place = std::max(change.end, begin);
    }
    return result + text_.substr(place, block.end - place);
  }

  const std::string& text_;
  const std::string& path_;
  const RobotModel& robot_;
  YAML::Node root_, list_;
  std::vector<Block> blocks_;
  std::string indent_;
};

}  // namespace

std::vector<KeyframeDraft> draftOf(const KeyframeMotion& motion, const RobotModel& robot) {
  std::vector<KeyframeDraft> drafts;
  for (const Keyframe& keyframe : motion.keyframes) {
    KeyframeDraft draft{static_cast<int>(drafts.size()), keyframe.seconds, keyframe.settleSeconds, {}};
    for (std::size_t j = 0; j < keyframe.set.size(); ++j)
      if (keyframe.set[j])
        draft.degrees[std::string(robot.jointName(static_cast<JointId>(j)))] =
            std::round(1e6 * toDegrees(keyframe.angles[j])) / 1e6;
    drafts.push_back(std::move(draft));
  }
  return drafts;
}

std::string editedText(const std::string& text, const std::string& path,
                       const std::vector<KeyframeDraft>& keyframes, const RobotModel& robot) {
  return Editor(text, path, robot).edited(keyframes);
}

}  // namespace plumbline::motion
