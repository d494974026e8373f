#include "gap/report/MotionDesigns.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gap/record/Postures.h"

namespace plumbline::gap {

namespace {

constexpr double leadIn = 0.4, leadOut = 0.5, length = 13;  // [s]

class Designer {
public:
  Designer(const Mechanism& robot, const std::vector<int>& joints) : robot_(robot) {
    for (int joint : joints) {
      joint = robot_.motorOf(joint);
      if (std::ranges::find(joints_, joint) == joints_.end()) joints_.push_back(joint);
    }
    home_ = namedPosture("hang", robot_).value_or(neutralPosture(robot_));
    for (const int joint : joints_)
      names_ += (names_.empty() ? "" : ", ") + robot_.joints[static_cast<std::size_t>(joint)].name;
    if (joints_.size() > 4) names_ = std::to_string(joints_.size()) + " joints";
  }

  std::vector<Excitation> all() {
    for (const double share : {0.2, 0.6})
      oneWave("triangle", "slow triangles", Segment::Kind::triangle, share, 2);
    for (const double share : {0.03, 0.1, 0.3}) oneWave("chirp", "chirps", Segment::Kind::chirp, share, 6);
    for (const double share : {0.05, 0.15, 0.4, 0.8})
      oneWave("steps", "steps", Segment::Kind::steps, share, 1);
    for (const double share : {0.3, 0.65, 0.9}) oneWave("fast", "fast moves", Segment::Kind::fast, share, 1);
    for (const double share : {0.1, 0.35})
      oneWave("multisine", "multisines", Segment::Kind::multisine, share, 5);
    for (const double size : {0.015, 0.05, 0.15}) reversals(size);
    poses();
    return std::move(designs_);
  }

private:
  Excitation begin(const std::string& name, const std::string& what) const {
    Excitation e;
    e.name = name;
    e.about = "next_" + name + ": " + what + " of " + names_;
    e.posture = home_;
    e.duration = leadIn;
    return e;
  }

  /// As far as `share` of the way to the nearer stop (or `most`), and never faster than the joint can.
  std::vector<std::pair<int, double>> sizes(const std::vector<double>& posture, double share, double most,
                                            double fastest) const {
    std::vector<std::pair<int, double>> result;
    for (const int j : joints_) {
      const auto& joint = robot_.joints[static_cast<std::size_t>(j)];
      const double q = posture[static_cast<std::size_t>(j)];
      double size = std::min(most, share * std::clamp(std::min(joint.upper - q, q - joint.lower), 0.0, M_PI));
      if (fastest > 0) size = std::min(size, 0.85 * joint.maxSpeed / fastest);
      result.emplace_back(j, size);
    }
    return result;
  }

  /// Repeats of one wave that fill the program; joints of one chain all take part, in turn where there are
  /// few of them.
  void oneWave(const std::string& name, const std::string& what, Segment::Kind kind, double share,
               double hz) {
    char size[16];
    std::snprintf(size, sizeof size, "%02.0f", 100 * share);
    Excitation e = begin(name + size, what);
    Segment wave;
    wave.kind = kind;
    wave.fromHz = kind == Segment::Kind::chirp ? 0.5 : 0.2;
    wave.toHz = hz;
    wave.cycles = static_cast<int>(hz);
    const bool long_ = kind == Segment::Kind::fast || kind == Segment::Kind::multisine;
    const int repeats = long_ ? 1 : kind == Segment::Kind::triangle ? 2 : 4;
    wave.duration = length / repeats;
    double fastest = 0;
    if (kind == Segment::Kind::chirp) fastest = 2 * M_PI * hz;
    if (kind == Segment::Kind::multisine) fastest = M_PI * hz;
    if (kind == Segment::Kind::triangle) fastest = 4.4 * wave.cycles / wave.duration;
    for (int i = 0; i < repeats; ++i) {
      wave.start = e.duration;
      wave.seed = static_cast<std::uint64_t>(i + 1);
      wave.joints = sizes(home_, share, 10, fastest);
      if (i % 2)
        for (auto& [joint, amplitude] : wave.joints) amplitude = -amplitude;
      e.segments.push_back(wave);
      e.duration += wave.duration;
    }
    finish(std::move(e));
  }

  void move(Excitation& e, const std::vector<double>& from, const std::vector<double>& to) const {
    Segment segment;
    segment.kind = Segment::Kind::move;
    segment.start = e.duration;
    segment.duration = 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      if (to[j] == from[j]) continue;
      segment.joints.emplace_back(static_cast<int>(j), to[j]);
      segment.duration =
          std::max(segment.duration, 1.875 * std::abs(to[j] - from[j]) / (0.5 * robot_.joints[j].maxSpeed));
    }
    e.segments.push_back(segment);
    e.duration += segment.duration;
  }

  void reversals(double size) {
    char text[16];
    std::snprintf(text, sizeof text, "%03.0f", 1000 * size);
    Excitation e = begin(std::string("reversals") + text, "slow small reversals at four gravity loadings");
    std::vector<double> now = home_;
    for (const std::vector<double>& loading : gravityLoadings(robot_, home_, 0.65, 4, 3)) {
      move(e, now, loading);
      now = loading;
      Segment wave;
      wave.kind = Segment::Kind::triangle;
      wave.start = e.duration;
      wave.duration = 2.6;
      wave.cycles = 2;
      wave.joints = sizes(loading, 0.9, size, 4.4 * wave.cycles / wave.duration);
      e.segments.push_back(wave);
      e.duration += wave.duration;
    }
    finish(std::move(e));
  }

  void poses() {
    Excitation e = begin("poses", "static poses at other gravity loadings, through");
    std::vector<double> now = home_;
    for (const std::vector<double>& loading : gravityLoadings(robot_, home_, 0.8, 6, 5)) {
      move(e, now, loading);
      now = loading;
      e.duration += 1.2;
    }
    finish(std::move(e));
  }

  void finish(Excitation e) {
    e.duration += leadOut;
    designs_.push_back(std::move(e));
  }

  const Mechanism& robot_;
  std::vector<int> joints_;
  std::vector<double> home_;
  std::string names_;
  std::vector<Excitation> designs_;
};

}  // namespace

std::vector<Excitation> motionDesigns(const Mechanism& robot, const std::vector<int>& joints) {
  return Designer(robot, joints).all();
}

}  // namespace plumbline::gap
