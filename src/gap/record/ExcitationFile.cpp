#include "gap/record/ExcitationFile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "gap/record/Postures.h"

namespace plumbline::gap {
namespace {

namespace fs = std::filesystem;
constexpr double longest = 3600;  // s
using Kind = Segment::Kind;

class Reader {
public:
  Reader(const std::string& path, const Mechanism& robot, std::uint64_t seed)
      : file_(path),
        root_(file_.root()),
        robot_(robot),
        seed_(seed),
        folder_(fs::path(path).parent_path().string()) {
    result_.name = fs::path(path).stem().string();
  }

  Excitation read() {
    result_.about = root_.get<std::string>("about");
    result_.freeBase = root_.choice("base", {"fixed", "free"}) == 1;
    result_.heading = root_.find<double>("heading", Range{-100, 100}).value_or(0);
    if (root_.has("walk")) return readWalk();
    posture_ = result_.posture = postureOf(root_, "posture");
    now_ = root_.find<double>("lead_in", Range{0, 60}).value_or(0.4);
    for (const ConfigSection& entry : root_.list("segments")) readSegment(entry);
    result_.duration = now_ + root_.find<double>("lead_out", Range{0, 60}).value_or(0.5);
    file_.checkUnknown();
    return std::move(result_);
  }

private:
  Excitation readWalk() {
    const ConfigSection entry = root_.section("walk");
    if (!result_.freeBase) entry.fail("forward", "needs base: free; a robot with a fixed base does not walk");
    WalkSegment walk;
    const Range speed{-2, 2};
    walk.velocity.x() = entry.find<double>("forward", speed).value_or(0);
    walk.velocity.y() = entry.find<double>("left", speed).value_or(0);
    walk.turn = entry.find<double>("turn", Range{-3, 3}).value_or(0);
    walk.duration = entry.get<double>("duration", Range{0.1, longest});
    walk.standBefore = root_.find<double>("lead_in", Range{0, 60}).value_or(walk.standBefore);
    walk.standAfter = root_.find<double>("lead_out", Range{0, 60}).value_or(walk.standAfter);
    file_.checkUnknown();
    result_.posture.assign(robot_.joints.size(), 0);
    result_.duration = walk.standBefore + walk.duration + walk.standAfter;
    result_.walk = walk;
    return std::move(result_);
  }

  std::vector<double> postureOf(const ConfigSection& section, const char* key) {
    std::vector<double> positions = posture_.empty() ? neutralPosture(robot_) : posture_;
    for (const ConfigSection& map : isMap(section, key) ? std::vector<ConfigSection>{section.section(key)}
                                                        : std::vector<ConfigSection>{})
      for (const std::string& joint : map.keys())
        positions[jointIndex(map, joint)] = map.get<double>(joint, Range{-1e3, 1e3});
    if (!isMap(section, key)) {
      const std::string name = section.get<std::string>(key);
      const auto known = namedPosture(name, robot_, folder_);
      if (!known)
        section.fail(key,
                     "is \"" + name + "\", a posture that postures.yaml does not have for " + robot_.name);
      positions = *known;
    }
    return positions;
  }

  static bool isMap(const ConfigSection& section, const char* key) {
    try {
      return section.section(key), true;
    } catch (const ConfigurationError&) {
      return false;
    }
  }

  std::size_t jointIndex(const ConfigSection& section, const std::string& joint) const {
    const int index = robot_.jointIndex(joint);
    if (index >= 0) return static_cast<std::size_t>(index);
    section.fail(joint, "is no joint of " + robot_.name + suggestion(joint, robot_.jointNames()));
  }

  void readSegment(const ConfigSection& entry) {
    if (entry.has("hold"))
      now_ += entry.get<double>("hold", Range{0, longest});
    else if (entry.has("move"))
      readMove(entry);
    else if (entry.has("in_turn"))
      readInTurn(entry);
    else if (entry.has("reversals"))
      readReversals(entry);
    else {
      const double start = entry.find<bool>("with_last").value_or(false) ? lastStart_ : now_;
      Segment segment = readWave(entry);
      setJoints(entry, segment, wantedJoints(entry));
      add(segment, start);
    }
    if (now_ <= longest) return;
    for (const char* key : {"hold", "move", "in_turn", "reversals", "wave"})
      if (entry.has(key)) entry.fail(key, "makes the program longer than an hour");
  }

  void add(Segment segment, double start) {
    segment.start = lastStart_ = start;
    now_ = std::max(now_, start + segment.duration);
    result_.segments.push_back(std::move(segment));
    if (result_.segments.size() > 20'000)
      throw ConfigurationError(result_.name + ": more than 20000 segments");
  }

  void readMove(const ConfigSection& entry) {
    Segment segment;
    segment.kind = Kind::move;
    const std::vector<double> target = postureOf(entry, "move");
    segment.duration = entry.find<double>("duration", Range{0, 60}).value_or(1);
    moveTo(target, segment);
  }

  void moveTo(const std::vector<double>& target, Segment segment) {
    for (std::size_t j = 0; j < target.size(); ++j)
      if (target[j] != posture_[j]) segment.joints.emplace_back(static_cast<int>(j), target[j]);
    posture_ = target;
    add(segment, now_);
  }

  static bool isSine(const Segment& segment) {
    return segment.kind == Kind::sine || segment.kind == Kind::bumps;
  }

  Segment readWave(const ConfigSection& entry) {
    Segment segment;
    constexpr Kind kinds[] = {Kind::triangle,  Kind::chirp, Kind::steps, Kind::sine,
                              Kind::multisine, Kind::fast,  Kind::bumps};
    segment.kind =
        kinds[entry.choice("wave", {"triangle", "chirp", "steps", "sine", "multisine", "fast", "bumps"})];
    segment.duration = entry.get<double>("duration", Range{0.01, longest});
    const Range frequency{1e-3, 100};
    segment.fromHz =
        entry.find<double>(isSine(segment) ? "hz" : "from_hz", frequency).value_or(segment.fromHz);
    segment.phase = entry.find<double>("phase", Range{-1, 1}).value_or(0);
    segment.toHz = entry.find<double>("to_hz", frequency).value_or(segment.toHz);
    segment.cycles = entry.find<int>("cycles", Range{1, 1000}).value_or(1);
    segment.tones = entry.find<int>("tones", Range{1, 200}).value_or(12);
    segment.speed = entry.find<double>("speed", Range{0.01, 1}).value_or(0.85);
    segment.seed = static_cast<std::uint64_t>(entry.find<std::int64_t>("seed", Range{0, 1e15}).value_or(1)) +
                   7919 * seed_;
    return segment;
  }

  /// Joints with their coefficients: a map, a list, or `all` (also when left out).
  std::vector<std::pair<int, double>> wantedJoints(const ConfigSection& entry) {
    std::vector<std::pair<int, double>> wanted;
    if (entry.has("joints") && isMap(entry, "joints")) {
      const ConfigSection map = entry.section("joints");
      for (const std::string& joint : map.keys())
        wanted.emplace_back(static_cast<int>(jointIndex(map, joint)),
                            map.get<double>(joint, Range{-100, 100}));
      return wanted;
    }
    std::vector<std::string> names;
    if (entry.has("joints")) {
      try {
        names = entry.get<std::vector<std::string>>("joints");
      } catch (const ConfigurationError&) {
        names = {entry.get<std::string>("joints")};
      }
    }
    if (names.empty() || (names.size() == 1 && names[0] == "all")) {
      for (int j = 0; j < robot_.numJoints(); ++j)
        if (robot_.joints[static_cast<std::size_t>(j)].driver < 0) wanted.emplace_back(j, 1);
    } else {
      for (const std::string& joint : names) {
        if (robot_.jointIndex(joint) < 0)
          entry.fail("joints", "names " + joint + ", which is no joint of " + robot_.name +
                                   suggestion(joint, robot_.jointNames()));
        wanted.emplace_back(robot_.jointIndex(joint), 1);
      }
    }
    return wanted;
  }

  /// How far the wave takes each joint: `amplitude` in rad, or `share` of the way to the nearer limit; never
  /// faster than the joint can turn, nor with more torque than it has.
  void setJoints(const ConfigSection& entry, Segment& segment,
                 const std::vector<std::pair<int, double>>& wanted) {
    const auto amplitude = entry.find<double>("amplitude", Range{0, 1e3});
    const auto share = entry.find<double>("share", Range{0, 1});
    if (amplitude.has_value() == share.has_value())
      entry.fail("wave", "needs amplitude or share, one of them");
    const std::vector<double> accelerations = reachableAccelerations(robot_, posture_);
    const double turn = 2 * M_PI;
    for (const auto& [j, coefficient] : wanted) {
      const Mechanism::Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
      const double q = posture_[static_cast<std::size_t>(j)];
      double size = amplitude.value_or(0);
      if (share) size = *share * std::max(0.0, std::min({joint.upper - q, q - joint.lower, M_PI}));
      double speed = 0, acceleration = 0;  // of a wave of size 1
      if (segment.kind == Kind::chirp || segment.kind == Kind::multisine) speed = turn * segment.toHz;
      if (isSine(segment)) speed = turn * segment.fromHz;
      acceleration = speed * speed;
      // A multisine's tones hardly ever meet.
      if (segment.kind == Kind::multisine) speed *= 0.5, acceleration *= 0.35;
      if (segment.kind == Kind::triangle) speed = 4.4 * segment.cycles / segment.duration;
      const double factor = std::max(1e-9, std::abs(coefficient)),
                   most = accelerations[static_cast<std::size_t>(j)];
      if (speed > 0) size = std::min(size, 0.85 * joint.maxSpeed / speed / factor);
      // A standing robot's legs carry more than what hangs on them: there the program is trusted.
      if (acceleration > 0 && !result_.freeBase) size = std::min(size, most / acceleration / factor);
      segment.joints.emplace_back(j, coefficient * size);
      if (segment.kind == Kind::fast) segment.accelerations.push_back(most);
    }
  }

  void readInTurn(const ConfigSection& entry) {
    std::vector<std::vector<int>> groups;
    if (entry.get<std::string>("in_turn") == "limbs")
      groups = jointsInTurn(robot_);
    else
      entry.fail("in_turn", "must be limbs");
    const std::vector<ConfigSection> waves = entry.list("do");
    const double pause = entry.find<double>("pause", Range{0, 60}).value_or(0.07);
    for (const std::vector<int>& group : groups) {
      for (const ConfigSection& wave : waves) {
        Segment segment = readWave(wave);
        std::vector<std::pair<int, double>> wanted;
        wanted.reserve(group.size());
        for (const int joint : group) wanted.emplace_back(joint, 1);
        setJoints(wave, segment, wanted);
        add(segment, now_);
      }
      now_ += pause;
    }
  }

  void readReversals(const ConfigSection& entry) {
    const int count = entry.get<int>("reversals", Range{1, 100});
    const double spread = entry.get<double>("share", Range{0, 1});
    const auto draw =
        static_cast<std::uint64_t>(entry.find<std::int64_t>("seed", Range{0, 1e15}).value_or(1)) +
        7919 * seed_;
    const double moving = entry.find<double>("move_time", Range{0, 60}).value_or(0.9);
    Segment wave;
    wave.kind = Kind::triangle;
    wave.duration = entry.find<double>("duration", Range{0.1, longest}).value_or(3.6);
    wave.cycles = entry.find<int>("cycles", Range{1, 1000}).value_or(3);
    const double amplitude = entry.get<double>("amplitude", Range{0, 10});
    const std::vector<double> home = posture_;
    for (const std::vector<double>& loading : gravityLoadings(robot_, home, spread, count, draw)) {
      Segment move;
      move.kind = Kind::move;
      move.duration = moving;
      moveTo(loading, move);
      Segment small = wave;
      const double sizes[] = {0.6, 1.0, 1.4};
      for (int j = 0; j < robot_.numJoints(); ++j) {
        const Mechanism::Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
        if (joint.driver >= 0) continue;
        const double most = std::min(0.25 * (joint.upper - joint.lower),
                                     0.2 * joint.maxSpeed * wave.duration / (4.4 * wave.cycles));
        small.joints.emplace_back(
            j, std::min(amplitude * sizes[(static_cast<std::size_t>(j) + loadings_) % 3], most));
      }
      ++loadings_;
      add(small, now_);
    }
  }

  ConfigFile file_;
  ConfigSection root_;
  const Mechanism& robot_;
  const std::uint64_t seed_;
  const std::string folder_;
  std::vector<double> posture_;
  double now_ = 0, lastStart_ = 0;
  std::size_t loadings_ = 0;
  Excitation result_;
};

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", x);
  return text;
}

std::string jointsText(const std::vector<std::pair<int, double>>& joints, const Mechanism& robot) {
  std::string text = "{";
  for (const auto& [j, x] : joints)
    text += (text.size() > 1 ? ", " : "") + robot.joints[static_cast<std::size_t>(j)].name + ": " + number(x);
  return text + "}";
}

}  // namespace

Excitation readExcitation(const std::string& file, const Mechanism& robot, std::uint64_t seed) {
  return Reader(file, robot, seed).read();
}

Excitation findExcitation(const std::string& name, const Mechanism& robot, std::uint64_t seed,
                          const std::string& givenFolder) {
  const std::string folder = givenFolder.empty() ? configPath("excitation") : givenFolder;
  const fs::path path = fs::path(folder) / (name + ".yaml");
  std::error_code error;
  if (name.find('/') == std::string::npos && name != "postures" && fs::exists(path, error))
    return readExcitation(path.string(), robot, seed);
  std::set<std::string> known;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".yaml" && entry.path().stem() != "postures")
      known.insert(entry.path().stem().string());
  std::string list;
  for (const std::string& k : known) list += (list.empty() ? "" : ", ") + k;
  throw ConfigurationError(folder + ": no program " + name + "; there are " + (list.empty() ? "none" : list));
}

std::string excitationText(const Excitation& excitation, const Mechanism& robot) {
  if (excitation.walk)
    throw std::invalid_argument(excitation.name + " is a walk: its commands are not known before");
  std::vector<std::pair<int, double>> start;
  start.reserve(excitation.posture.size());
  for (int j = 0; j < robot.numJoints(); ++j)
    start.emplace_back(j, excitation.posture[static_cast<std::size_t>(j)]);
  std::string about = excitation.about;
  std::replace(about.begin(), about.end(), '"', '\'');
  std::string text = "about: \"" + about + "\"\nbase: " + (excitation.freeBase ? "free" : "fixed") +
                     "\nheading: " + number(excitation.heading) + "\nposture: " + jointsText(start, robot) +
                     "\nlead_in: 0\nsegments:\n";
  double now = 0;
  for (const Segment& s : excitation.segments) {
    // Segments that begin together follow each other in the file; a hold fills what lies between.
    if (s.start > now + 1e-9) text += "  - {hold: " + number(s.start - now) + "}\n";
    const bool together = s.start < now - 1e-9;
    now = std::max(now, s.start + s.duration);
    if (s.kind == Kind::move) {
      text += "  - {move: " + jointsText(s.joints, robot) + ", duration: " + number(s.duration) + "}\n";
      continue;
    }
    text += std::string("  - {wave: ") + name(s.kind) + ", duration: " + number(s.duration);
    if (together) text += ", with_last: true";
    if (s.kind == Kind::sine || s.kind == Kind::bumps) text += ", hz: " + number(s.fromHz);
    if (s.phase != 0) text += ", phase: " + number(s.phase);
    if (s.kind == Kind::chirp || s.kind == Kind::multisine)
      text += ", from_hz: " + number(s.fromHz) + ", to_hz: " + number(s.toHz);
    if (s.kind == Kind::triangle) text += ", cycles: " + std::to_string(s.cycles);
    if (s.kind == Kind::multisine) text += ", tones: " + std::to_string(s.tones);
    if (s.kind == Kind::fast) text += ", speed: " + number(s.speed);
    if (s.kind == Kind::multisine || s.kind == Kind::fast) text += ", seed: " + std::to_string(s.seed);
    text += ", amplitude: 1, joints: " + jointsText(s.joints, robot) + "}\n";
  }
  return text + "lead_out: " + number(std::max(0.0, excitation.duration - now)) + "\n";
}

std::vector<std::string> hangingBattery() {
  return {"hang_sweep", "hang_multisine", "hang_small", "hang_fast"};
}
std::vector<std::string> floatingBaseBattery() {
  return {"stand_squat", "stand_sway", "stand_lean", "stand_turn180"};
}

}  // namespace plumbline::gap
