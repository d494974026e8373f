#include "robot/MechanismParts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>

#include "framework/SingleLine.h"
#include "robot/MechanismFile.h"

namespace plumbline {
namespace {

constexpr std::size_t maxParts = 512;
using Joint = Mechanism::Joint;

/// The sum of a group of links joined by fixed joints, in the frame of its first link.
struct Body {
  std::string name;
  double mass = 0;
  Vec3 moment = Vec3::Zero();   ///< mass times com
  Mat3 inertia = Mat3::Zero();  ///< about the frame's origin
  int links = 0;
  const Mechanism::Link* only = nullptr;
  std::optional<Shape> shape;  ///< of its first link
  bool collides = false;

  void add(const Mechanism::Link& link, const Pose3& T_body_link) {
    const Vec3 com = T_body_link * link.com;
    mass += link.mass;
    moment += link.mass * com;
    inertia += T_body_link.linear() * link.inertia * T_body_link.linear().transpose() +
               link.mass * (com.squaredNorm() * Mat3::Identity() - com * com.transpose());
    only = ++links == 1 ? &link : nullptr;
    if (!only) return;
    shape = link.shape;
    collides = link.collides;
  }

  Mechanism::Link finish() const {
    if (only) return *only;  // exactly as written
    Mechanism::Link link;
    link.shape = shape;
    link.collides = collides;
    link.mass = mass;
    if (mass > 0) link.com = moment / mass;
    link.inertia =
        inertia - mass * (link.com.squaredNorm() * Mat3::Identity() - link.com * link.com.transpose());
    return link;
  }
};

class Assembler {
public:
  Assembler(const MechanismParts& parts, const std::string& file) : parts_(parts), file_(file) {}

  Mechanism run() {
    if (parts_.links.size() > maxParts || parts_.joints.size() > maxParts)
      fail("more than " + std::to_string(maxParts) + " links or joints");
    index();
    placeLinks();
    finishLinks();
    finishDrivers();
    finishGroups();
    finishSensors();
    result_.name = parts_.name;
    result_.gravity = parts_.gravity;
    result_.controlHz = parts_.controlHz;
    return std::move(result_);
  }

private:
  [[noreturn]] void fail(const std::string& what) const { failMechanism(file_, what); }

  void index() {
    for (std::size_t i = 0; i < parts_.links.size(); ++i)
      if (!linkAt_.emplace(parts_.links[i].name, i).second)
        fail("link " + parts_.links[i].name + " occurs twice; rename one");
    std::map<std::string, std::string> moverOf;
    std::map<std::string, int> names;
    for (const auto& [joint, parent, child, driver, type, fixed, servo, driven, ratio] : parts_.joints) {
      if (++names[joint.name] > 1) fail("joint " + joint.name + " occurs twice; rename one");
      for (const std::string& end : {parent, child})
        if (!linkAt_.count(end)) fail("joint " + joint.name + ": there is no link " + end);
      if (const auto [it, isNew] = moverOf.emplace(child, joint.name); !isNew)
        fail("link " + child + " is the child of both " + it->second + " and " + joint.name +
             "; a robot is a tree");
    }
    std::vector<std::string> roots;
    for (const Mechanism::Link& link : parts_.links)
      if (!moverOf.count(link.name)) roots.push_back(link.name);
    if (roots.empty()) fail("no link is the base: the joints form a ring");
    if (roots.size() > 1)
      fail("links " + roots[0] + " and " + roots[1] +
           " have no joint that connects them; connect one of them to the rest");
    if (!parts_.base.empty() && parts_.base != roots[0])
      fail("base_link is " + parts_.base + ", but the joints start at " + roots[0]);
    bodies_.push_back({});
    bodies_[0].name = roots[0];
    enter(roots[0], 0, Pose3::Identity());
  }

  void enter(const std::string& link, int body, const Pose3& T_body_link) {
    placed_[link] = {body, T_body_link};
    bodies_[static_cast<std::size_t>(body)].add(parts_.links[linkAt_[link]], T_body_link);
    if (link != bodies_[static_cast<std::size_t>(body)].name)
      result_.frames.push_back({link, body, T_body_link});
  }

  /// Repeatedly takes the first joint of the file whose parent is placed: parents come first, otherwise the
  /// file's order is kept.
  void placeLinks() {
    std::vector<bool> done(parts_.joints.size());
    for (std::size_t placedJoints = 0; placedJoints < done.size(); ++placedJoints) {
      std::size_t next = 0;
      while (next < done.size() && (done[next] || !placed_.count(parts_.joints[next].parent))) ++next;
      if (next == done.size()) {
        next = static_cast<std::size_t>(std::find(done.begin(), done.end(), false) - done.begin());
        fail("joint " + parts_.joints[next].joint.name + " hangs in a ring of links; a robot is a tree");
      }
      done[next] = true;
      place(parts_.joints[next]);
    }
  }

  void place(const MechanismParts::Joint& part) {
    const auto [parentBody, T_body_parent] = placed_[part.parent];
    if (part.fixed) {
      enter(part.child, parentBody, T_body_parent * part.joint.T_parent_joint());
      return;
    }
    Joint joint = part.joint;
    if (!part.hasServo) fail("joint " + joint.name + " has no servo; give it kp, kd and armature");
    if (!T_body_parent.isApprox(Pose3::Identity(), 0)) {
      const Pose3 T_body_joint = T_body_parent * joint.T_parent_joint();
      joint.origin = T_body_joint.translation();
      joint.rpy = rpyOfRotation(T_body_joint.linear());
    }
    joint.parent = parentBody;
    joint.child = static_cast<int>(bodies_.size());
    bodies_.push_back({});
    bodies_.back().name = part.child;
    enter(part.child, joint.child, Pose3::Identity());
    result_.joints.push_back(joint);
    drivers_.push_back(part.driver);
  }

  void finishLinks() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Mechanism::Link link = bodies_[i].finish();
      link.name = bodies_[i].name;
      link.parent = i == 0 ? -1 : result_.joints[i - 1].parent;
      if (i > 0 && !(link.mass > 0))
        fail("link " + link.name + ": mass is " + numberText(link.mass) + "; give what moves a mass");
      result_.links.push_back(std::move(link));
    }
  }

  void finishDrivers() {
    for (std::size_t j = 0; j < drivers_.size(); ++j) {
      if (drivers_[j].empty()) continue;
      Joint& joint = result_.joints[j];
      joint.driver = result_.jointIndex(drivers_[j]);
      if (joint.driver < 0)
        fail("joint " + joint.name + " is driven by " + drivers_[j] + ", which is no joint");
      if (joint.driver == static_cast<int>(j)) fail("joint " + joint.name + " is driven by itself");
      const auto driver = static_cast<std::size_t>(joint.driver);
      if (!drivers_[driver].empty())
        fail("joint " + joint.name + " is driven by " + drivers_[j] + ", which has no motor of its own");
    }
  }

  /// The groups that the file names, then one for each type of servo.
  void finishGroups() {
    for (const MechanismParts::Group& group : parts_.groups) {
      if (result_.jointIndex(group.name) >= 0 || result_.linkIndex(group.name) >= 0 || group.name == "imu" ||
          group.name == "ground")
        fail("group " + group.name + " has the name of something else; rename it");
      std::vector<int> joints;
      for (const std::string& joint : group.joints) {
        joints.push_back(result_.jointIndex(joint));
        if (joints.back() < 0) fail("group " + group.name + ": there is no joint " + joint);
      }
      addGroup(group.name, std::move(joints));
      if (motorsOf(result_.groups.back()) < 2)
        fail("group " + group.name + " has fewer than two motors; give it more joints");
    }
    std::map<std::string, std::vector<int>> ofType;
    for (const MechanismParts::Joint& part : parts_.joints)
      if (!part.servoType.empty()) ofType[part.servoType].push_back(result_.jointIndex(part.joint.name));
    for (auto& [type, joints] : ofType) {
      if (std::ranges::any_of(result_.groups,
                              [&type = type](const auto& group) { return group.name == type; }))
        fail("group " + type + " has the name of a type of servo; rename it");
      if (result_.jointIndex(type) >= 0 || result_.linkIndex(type) >= 0)
        fail("the type of servo " + type + " has the name of something else; rename it");
      addGroup(type, std::move(joints));
      // One motor needs no group; all motors of one type are "*".
      if (motorsOf(result_.groups.back()) < 2 || result_.sharesServo()) result_.groups.pop_back();
    }
  }

  void addGroup(const std::string& name, std::vector<int> joints) {
    std::ranges::sort(joints);
    if (std::ranges::adjacent_find(joints) != joints.end())
      fail("group " + name + " names joint " +
           result_.joints[static_cast<std::size_t>(*std::ranges::adjacent_find(joints))].name + " twice");
    result_.groups.push_back({name, std::move(joints)});
  }

  std::size_t motorsOf(const Mechanism::Group& group) const {
    std::set<int> motors;
    for (const int joint : group.joints) motors.insert(result_.motorOf(joint));
    return motors.size();
  }

  int linkOrFail(const std::string& name, const std::string& of) const {
    const int link = result_.linkIndex(name);
    if (link < 0) fail(of + ": there is no link " + name);
    return link;
  }

  Pose3 frameOf(const std::string& link) const { return placed_.at(link).second; }

  void finishSensors() {
    if (!parts_.imuLink.empty()) {
      result_.hasImu = true;
      result_.imu = parts_.imu;
      result_.imu.link = linkOrFail(parts_.imuLink, "imu");
      const Pose3 T = frameOf(parts_.imuLink);
      result_.imu.gyro = T * parts_.imu.gyro;
      result_.imu.accelerometer = T * parts_.imu.accelerometer;
      if (!T.linear().isIdentity(0))
        result_.imu.rpy = rpyOfRotation(T.linear() * rotationOfRpy(parts_.imu.rpy));
    }
    for (const MechanismParts::Foot& part : parts_.feet) {
      Mechanism::Foot foot = part.foot;
      const std::string link = part.link.empty() ? lowestLink(foot.name) : part.link;
      foot.link = linkOrFail(link, "foot " + foot.name);
      const Pose3 T = frameOf(link);
      if (!T.linear().isIdentity(1e-9))
        fail("foot " + foot.name + ": link " + link +
             " is turned against what it is fixed to; name that link");
      for (Mechanism::ForceSensor& sensor : foot.sensors) sensor.position += T.translation();
      if (foot.soleSize.isZero(0))
        coverSensors(foot);
      else
        foot.soleCentre += T.translation();
      result_.feet.push_back(std::move(foot));
    }
  }

  /// The lowest link with all joints at zero among those whose name begins with the foot's first letter.
  std::string lowestLink(const std::string& foot) const {
    const std::vector<Pose3> poses = linkPoses(result_, std::vector<double>(result_.joints.size(), 0));
    int best = -1;
    double height = 0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
      if (std::tolower(static_cast<unsigned char>(result_.links[i].name[0])) !=
          std::tolower(static_cast<unsigned char>(foot[0])))
        continue;
      // Of links whose frames coincide the last carries the sole.
      if (best < 0 || poses[i].translation().z() <= height + 1e-9) {
        best = static_cast<int>(i);
        height = poses[i].translation().z();
      }
    }
    if (best < 0)
      fail("fsr " + foot + ": no link begins with the same letter; add feet: [{name: " + foot +
           ", link: ...}]");
    return result_.links[static_cast<std::size_t>(best)].name;
  }

  static void coverSensors(Mechanism::Foot& foot) {
    if (foot.sensors.empty()) return;
    Eigen::AlignedBox3d box;
    for (const Mechanism::ForceSensor& sensor : foot.sensors) box.extend(sensor.position);
    constexpr double thickness = 0.01;
    foot.soleCentre = box.center() + Vec3(0, 0, thickness / 2);
    foot.soleSize = Vec3(box.sizes().x(), box.sizes().y(), thickness);
  }

  const MechanismParts& parts_;
  const std::string& file_;
  Mechanism result_;
  std::map<std::string, std::size_t> linkAt_;
  std::map<std::string, std::pair<int, Pose3>> placed_;
  std::vector<Body> bodies_;
  std::vector<std::string> drivers_;
};

}  // namespace

MechanismParts::Joint* MechanismParts::find(const std::string& joint) {
  for (Joint& j : joints)
    if (j.joint.name == joint) return &j;
  return nullptr;
}

Mechanism assemble(const MechanismParts& parts, const std::string& file) {
  return Assembler(parts, file).run();
}

Vec3 unitAxis(const Vec3& axis) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  return std::abs(axis.squaredNorm() - 1) <= rounding ? axis : axis.normalized();
}

void failMechanism(const std::string& file, const std::string& what) {
  throw MechanismError(singleLine(file + ": " + what));  // names and numbers come from the file
}

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

void checkName(const std::string& name, const std::string& what, const std::string& file) {
  constexpr std::size_t maxLength = 80;
  const bool bad =
      name.empty() || name.size() > maxLength || std::any_of(name.begin(), name.end(), [](char c) {
        return static_cast<unsigned char>(c) <= ' ' || c == 127 ||
               std::string_view(".,/\\\"'*").find(c) != std::string_view::npos;
      });
  if (!bad) return;
  const std::string shown = name.substr(0, maxLength);
  failMechanism(file, what + " \"" + shown +
                          "\" is not a valid name; use up to 80 characters without blanks, dots, commas, "
                          "slashes, quotes and stars");
}

}  // namespace plumbline
