#include "motion/KeyframeReader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>

#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "framework/SingleLine.h"
#include "framework/YamlDocument.h"
#include "math/Angle.h"

namespace plumbline::motion {

namespace fs = std::filesystem;

namespace {

constexpr double maxSeconds = 60;        // a longer keyframe is a slip of the pen
constexpr double limitTolerance = 1e-6;  // [rad]; degrees do not convert exactly
constexpr double maxBallDistance = 1;    // [m]
constexpr double maxKickDistance = 50;   // [m]

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Everything a key of a keyframe can be, besides a single joint: a name without its side means both.
std::vector<std::string> keyframeWords(const RobotModel& robot) {
  std::vector<std::string> words = {"time", "settle", "ballX", "ballY"};
  for (int j = 0; j < maxJoints; ++j) {
    const auto joint = static_cast<JointId>(j);
    if (joint >= numHumanoidJoints && !robot.has(joint)) continue;
    words.emplace_back(robot.jointName(joint));
    if (const std::string both = bothSides(robot, joint); !both.empty()) words.push_back(both);
  }
  return words;
}

class Reader {
public:
  Reader(const fs::path& file, const RobotModel& robot, const std::vector<fs::path>& directories, int depth)
      : file_(file), robot_(robot), directories_(directories), depth_(depth) {}

  KeyframeMotion read() {
    try {
      return read(readYaml(file_.string(), maxKeyframeFileBytes));
    } catch (const ConfigurationError& error) {
      throw KeyframeFileError(error.what());
    }
  }

  KeyframeMotion read(const YAML::Node& root) {
    if (!root.IsMap()) fail(root, "", "a motion is a map with the key keyframes (or mirror)");
    KeyframeMotion motion;
    bool restStays = false;
    checkRobots(root);
    if (root["mirror"]) {
      motion = readMirrored(root);
    } else {
      forEachKey(root, [&](const std::string& key, const YAML::Node& keyNode, const YAML::Node& value) {
        if (key == "keyframes")
          readKeyframes(value, motion);
        else if (key == "ball")
          motion.ball = readPair(value, key, -maxBallDistance);
        else if (key == "ballReach")
          motion.ballReach = readPair(value, key, 0);
        else if (key == "kick")
          motion.kick = readKick(value);
        else if (key == "rest")
          restStays = readRest(value);
        else if (key != "robots")
          fail(keyNode, key,
               "unknown key" +
                   suggestion(key, {"keyframes", "mirror", "robots", "ball", "ballReach", "kick", "rest"}));
      });
      if (motion.keyframes.empty()) fail(root, "keyframes", "missing or empty");
      if (motion.kick && !root["ball"])
        fail(root["kick"], "kick", "needs ball, the place that it kicks from");
      if (!restStays) checkComplete(root, motion);
      checkReach(root, motion);
    }
    motion.name = file_.stem().string();
    return motion;
  }

private:
  template <class Error = KeyframeFileError>
  [[noreturn]] void fail(const YAML::Node& where, const std::string& key, const std::string& what) const {
    const int line = where.Mark().is_null() ? 1 : where.Mark().line + 1;
    throw Error(singleLine(file_.string() + ":" + std::to_string(line) + ": " +
                           (key.empty() ? "" : key + ": ") + what));
  }

  /// A name, or the beginning of names and a star; also several in a list.
  void checkRobots(const YAML::Node& root) const {
    const YAML::Node value = root["robots"];
    if (!value) return;
    const std::size_t count = value.IsSequence() ? value.size() : 1;
    bool ours = false, wrong = count == 0;
    for (std::size_t i = 0; i < count && !wrong; ++i) {
      const YAML::Node node = value.IsSequence() ? value[i] : value;
      wrong = !node.IsScalar() || node.Scalar().empty();
      if (wrong) continue;
      const std::string& name = node.Scalar();
      ours = ours || (name.back() == '*' ? robot_.name.starts_with(name.substr(0, name.size() - 1))
                                         : robot_.name == name);
    }
    if (wrong)
      fail(value, "robots", "has to be the name of a robot, as nao_v5 or simspark_type*, or a list of names");
    if (!ours) fail<MotionOfOtherRobots>(value, "robots", "the motion is not for robot " + robot_.name);
  }

  template <class Visit>
  void forEachKey(const YAML::Node& map, Visit visit) const {
    std::set<std::string> seen;
    for (const auto& item : map) {
      if (!item.first.IsScalar()) fail(item.first, "", "a key has to be a word");
      const std::string key = item.first.Scalar();
      if (!seen.insert(key).second) fail(item.first, key, "given twice");
      visit(key, item.first, item.second);
    }
  }

  double readNumber(const YAML::Node& value, const std::string& key) const {
    double number = 0;
    if (!value.IsScalar() || !YAML::convert<double>::decode(value, number) || !std::isfinite(number))
      fail(value, key, value.IsScalar() ? "\"" + value.Scalar() + "\" is not a number" : "not a number");
    return number;
  }

  double readSeconds(const YAML::Node& value, const std::string& key) const {
    const double seconds = readNumber(value, key);
    if (seconds < 0) fail(value, key, shortNumber(seconds) + " s is negative");
    if (seconds > maxSeconds) fail(value, key, shortNumber(seconds) + " s is more than 60 s");
    return seconds;
  }

  Vec2 readPair(const YAML::Node& value, const std::string& key, double lowest) const {
    if (!value.IsSequence() || value.size() != 2) fail(value, key, "has to be [x, y] in metres");
    Vec2 pair(readNumber(value[0], key), readNumber(value[1], key));
    if (pair.minCoeff() < lowest || pair.maxCoeff() > maxBallDistance)
      fail(value, key,
           "has to be between " + shortNumber(lowest) + " and " + shortNumber(maxBallDistance) + " m");
    return pair;
  }

  KickEffect readKick(const YAML::Node& value) const {
    if (!value.IsMap()) fail(value, "kick", "has to map distance, direction and contact to numbers");
    KickEffect kick;
    const auto within = [&](const YAML::Node& node, const std::string& key, double low, double high) {
      const double number = readNumber(node, key);
      if (number < low || number > high)
        fail(node, key, "has to be between " + shortNumber(low) + " and " + shortNumber(high));
      return number;
    };
    forEachKey(value, [&](const std::string& key, const YAML::Node& keyNode, const YAML::Node& node) {
      if (key == "distance")
        kick.distance = within(node, key, 0.1, maxKickDistance);
      else if (key == "direction")
        kick.direction = fromDegrees(within(node, key, -180, 180));
      else if (key == "contact")
        kick.contact = within(node, key, 0, maxSeconds);
      else if (key == "scatter")
        kick.scatter = fromDegrees(within(node, key, 0.1, 90));
      else if (key == "spread")
        kick.spread = within(node, key, 0.01, maxKickDistance);
      else if (key == "rise")
        kick.rise = within(node, key, 0, maxKickDistance);
      else
        fail(keyNode, key,
             "unknown key" +
                 suggestion(key, {"distance", "direction", "contact", "scatter", "spread", "rise"}));
    });
    if (!value["distance"]) fail(value, "distance", "missing; give the metres that the kick carries");
    return kick;
  }

  KeyframeMotion readMirrored(const YAML::Node& root) const {
    forEachKey(root, [&](const std::string& key, const YAML::Node& keyNode, const YAML::Node&) {
      if (key != "mirror") fail(keyNode, key, "a motion with mirror has no other key");
    });
    const YAML::Node value = root["mirror"];
    if (!value.IsScalar()) fail(value, "mirror", "has to be the name of a motion");
    const std::string& other = value.Scalar();
    if (depth_ > 0) fail(value, "mirror", "a mirrored motion cannot be mirrored again");
    for (auto directory = directories_.rbegin(); directory != directories_.rend(); ++directory) {
      const fs::path path = *directory / (other + ".yaml");
      if (fs::exists(path)) return mirrored(Reader(path, robot_, directories_, depth_ + 1).read());
    }
    fail(value, "mirror", "there is no motion " + other);
  }

  void readKeyframes(const YAML::Node& list, KeyframeMotion& motion) const {
    if (!list.IsSequence()) fail(list, "keyframes", "has to be a list");
    if (list.size() > maxKeyframes) fail(list, "keyframes", "more than " + std::to_string(maxKeyframes));
    for (const YAML::Node& node : list) motion.keyframes.push_back(readKeyframe(node));
  }

  Keyframe readKeyframe(const YAML::Node& node) const {
    if (!node.IsMap()) fail(node, "keyframes", "each has to be a map with time and joints");
    Keyframe frame;
    std::map<JointId, BallGain> gains;
    bool hasTime = false;
    forEachKey(node, [&](const std::string& key, const YAML::Node& keyNode, const YAML::Node& value) {
      if (key == "time") {
        frame.seconds = readSeconds(value, key);
        hasTime = true;
      } else if (key == "settle") {
        frame.settleSeconds = readSeconds(value, key);
      } else if (key == "ballX" || key == "ballY") {
        if (!value.IsMap()) fail(value, key, "has to map joints to degrees per metre");
        forEachKey(value, [&](const std::string& name, const YAML::Node& nameNode, const YAML::Node& gain) {
          const std::optional<JointId> joint = robot_.joint(name);
          if (!joint) failJoint(nameNode, name);
          gains[*joint].joint = *joint;
          gains[*joint].gain[key == "ballX" ? 0 : 1] = fromDegrees(readNumber(gain, name));
        });
      } else {
        readJoint(key, keyNode, value, frame);
      }
    });
    if (!hasTime) fail(node, "time", "missing; give the seconds from the keyframe before");
    for (const auto& [joint, gain] : gains) {
      if (!frame.set[joint])
        fail(node, nameOf(joint), "has a gain for the ball, but no angle in this keyframe");
      frame.ballGains.push_back(gain);
    }
    return frame;
  }

  [[noreturn]] void failJoint(const YAML::Node& node, const std::string& name) const {
    if (humanoidJoint(name) != noJoint || humanoidJoint("L" + name) != noJoint)
      fail(node, name, "robot " + robot_.name + " has no such joint");
    fail(node, name, "unknown joint" + suggestion(name, keyframeWords(robot_)));
  }

  std::string nameOf(JointId joint) const { return std::string(robot_.jointName(joint)); }

  void readJoint(const std::string& key, const YAML::Node& keyNode, const YAML::Node& value,
                 Keyframe& frame) const {
    const std::optional<JointId> one = robot_.joint(key), left = robot_.joint("L" + key);
    if (!one && (!left || bothSides(robot_, *left).empty())) failJoint(keyNode, key);
    const double degrees = readNumber(value, key);
    setJoint(one ? *one : *left, degrees, value, key, frame);
    if (!one) setJoint(mirrored(*left), mirrorSign(*left) * degrees, value, key, frame);
  }

  void setJoint(JointId joint, double degrees, const YAML::Node& value, const std::string& key,
                Keyframe& frame) const {
    if (frame.set[joint]) fail(value, key, nameOf(joint) + " has an angle already in this keyframe");
    const Link& link = robot_.linkMovedBy(joint);
    const double angle = fromDegrees(degrees);
    if (angle < link.lower - limitTolerance || angle > link.upper + limitTolerance)
      fail(value, key,
           shortNumber(degrees) + " degrees is out of the limits " + shortNumber(toDegrees(link.lower)) +
               " to " + shortNumber(toDegrees(link.upper)) + " of " + nameOf(joint) + " in robot " +
               robot_.name);
    frame.angles[joint] = angle;
    frame.set[joint] = true;
  }

  bool readRest(const YAML::Node& value) const {
    if (!value.IsScalar() || value.Scalar() != "stays")
      fail(value, "rest", "has to be stays: joints that a keyframe leaves out stay where they are");
    return true;
  }

  /// A joint that was lost from a keyframe would silently stay where it is. A keyframe that moves nothing is
  /// a pause.
  void checkComplete(const YAML::Node& root, const KeyframeMotion& motion) const {
    for (std::size_t i = 0; i < motion.keyframes.size(); ++i) {
      const auto& set = motion.keyframes[i].set;
      if (std::none_of(set.begin(), set.end(), [](bool named) { return named; })) continue;
      for (const Keyframe& other : motion.keyframes)
        for (std::size_t j = 0; j < set.size(); ++j)
          if (other.set[j] && !set[j])
            fail(root["keyframes"][i], nameOf(static_cast<JointId>(j)),
                 "has an angle in another keyframe, but not in this one; give it one, or write rest: stays "
                 "next to keyframes if joints that are left out shall stay where they are");
    }
  }

  /// The angles have to stay within the limits for every place of the ball.
  void checkReach(const YAML::Node& root, const KeyframeMotion& motion) const {
    for (std::size_t i = 0; i < motion.keyframes.size(); ++i)
      for (const BallGain& gain : motion.keyframes[i].ballGains) {
        const double swing = gain.gain.cwiseAbs().dot(motion.ballReach);
        const double angle = motion.keyframes[i].angles[gain.joint];
        const Link& link = robot_.linkMovedBy(gain.joint);
        if (angle - swing < link.lower - limitTolerance || angle + swing > link.upper + limitTolerance)
          fail(root["keyframes"][i], nameOf(gain.joint),
               "leaves its limits for a ball at the edge of ballReach");
      }
  }

  const fs::path& file_;
  const RobotModel& robot_;
  const std::vector<fs::path>& directories_;
  int depth_;
};

}  // namespace

std::string bothSides(const RobotModel& robot, JointId left) {
  const std::string_view name = robot.jointName(left);
  return mirrored(left) > left && name.front() == 'L' ? std::string(name.substr(1)) : "";
}

KeyframeMotion readKeyframeFile(const fs::path& file, const RobotModel& robot,
                                const std::vector<fs::path>& directories) {
  return Reader(file, robot, directories, 0).read();
}

KeyframeMotion readKeyframeText(const std::string& text, const fs::path& file, const RobotModel& robot,
                                const std::vector<fs::path>& directories) {
  try {
    return Reader(file, robot, directories, 0).read(parseYaml(text, file.string()));
  } catch (const ConfigurationError& error) {
    throw KeyframeFileError(error.what());
  }
}

std::map<std::string, fs::path> motionFiles(const std::vector<fs::path>& directories) {
  std::map<std::string, fs::path> files;
  for (std::size_t i = 0; i < directories.size(); ++i) {
    if (!fs::is_directory(directories[i])) {
      if (i == 0) throw KeyframeFileError(directories[i].string() + ": no such directory of motions");
      continue;
    }
    for (const auto& entry : fs::directory_iterator(directories[i]))
      if (entry.path().extension() == ".yaml") files[entry.path().stem().string()] = entry.path();
  }
  return files;
}

std::vector<KeyframeMotion> readMotions(const std::vector<fs::path>& directories, const RobotModel& robot) {
  const auto files = motionFiles(directories);
  std::vector<KeyframeMotion> motions;
  motions.reserve(files.size());
  for (const auto& [name, path] : files) {
    try {
      motions.push_back(readKeyframeFile(path, robot, directories));
    } catch (const MotionOfOtherRobots&) {
      // The robot does not have it.
    }
  }
  return motions;
}

}  // namespace plumbline::motion
