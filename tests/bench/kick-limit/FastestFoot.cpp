#include "FastestFoot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "math/Random.h"
#include "robot/ForwardKinematics.h"

namespace plumbline::bench {
namespace {

constexpr double lowestHit = 0.01, highestHit = 0.08;  // of a ball of 0.042 m [m above the ground]
constexpr double narrowest = 0.07;                     // between the feet's middles: they do not overlap [m]
constexpr int tries = 4000;                            // of each start

/// A posture of the legs and how fast the front of the foot is in it.
class Chain {
public:
  explicit Chain(const RobotModel& model) : model_(model), kinematics_(model) {
    for (const char* name : {"HipYawPitch", "HipRoll", "HipPitch", "KneePitch", "AnklePitch", "AnkleRoll"}) {
      left_.push_back(model.requireJoint(std::string("L") + name));
      right_.push_back(model.requireJoint(std::string("R") + name));
    }
    leftFoot_ = model.linkIndex("lFoot");
    rightFoot_ = model.linkIndex("rFoot");
    front_ = rightFoot_;
    if (const int toe = model.linkIndex("rToe"); toe >= 0) {
      front_ = toe;
      right_.push_back(model.requireJoint("RToePitch"));
    }
    joints_ = left_;
    joints_.insert(joints_.end(), right_.begin(), right_.end());
  }

  const std::vector<JointId>& joints() const { return joints_; }
  const Link& link(JointId joint) const { return model_.linkMovedBy(joint); }

  /// [m/s]; how far the posture is from an allowed one, as a negative number, if it is not. `both`: the left
  /// leg moves, too.
  double speed(const JointArray& angles, bool both) {
    kinematics_.update(angles);
    const Pose3 T_ground_torso = kinematics_.link(leftFoot_).inverse();
    const Link& stance = at(leftFoot_);
    const double ground = (stance.shape.T_link_shape.translation() - half(stance)).z();
    const Link& front = at(front_);
    const Pose3 T_ground_front = T_ground_torso * kinematics_.link(front_);
    // The middle of the front face.
    const Vec3 point = T_ground_front * (front.shape.T_link_shape * Vec3(half(front).x(), 0, 0));
    double missing = std::max({0.0, ground + lowestHit - point.z(), point.z() - ground - highestHit});
    for (const int foot : {rightFoot_, front_})
      missing += std::max(0.0, ground - lowest(T_ground_torso, foot));
    const Vec3 middle =
        T_ground_torso * (kinematics_.link(rightFoot_) * at(rightFoot_).shape.T_link_shape).translation();
    missing += std::max(0.0, narrowest + middle.y() - stance.shape.T_link_shape.translation().y());
    if (missing > 0) return -missing;
    double sum = 0;
    const auto add = [&](const std::vector<JointId>& joints) {
      for (const JointId joint : joints) {
        const Link& moved = link(joint);
        const Pose3 T_ground_link = T_ground_torso * kinematics_.link(model_.linkOfJoint[joint]);
        const Vec3 turn = T_ground_link.linear() * moved.axis;
        sum += moved.maxSpeed * std::abs(turn.cross(point - T_ground_link.translation()).x());
      }
    };
    add(right_);
    if (both) add(left_);
    return sum;
  }

private:
  const Link& at(int index) const { return model_.links[static_cast<std::size_t>(index)]; }
  static Vec3 half(const Link& foot) { return foot.shape.size / 2; }
  double lowest(const Pose3& T_ground_torso, int foot) const {
    const Pose3 T = T_ground_torso * kinematics_.link(foot) * at(foot).shape.T_link_shape;
    const Vec3 corner = half(at(foot));
    return T.translation().z() - T.linear().row(2).cwiseAbs().dot(corner);
  }

  const RobotModel& model_;
  ForwardKinematics kinematics_;
  std::vector<JointId> left_, right_, joints_;
  int leftFoot_ = -1, rightFoot_ = -1, front_ = -1;
};

/// Random steps that shrink where nothing better is found, from a random posture.
double climb(Chain& chain, bool both, Random& random) {
  JointArray best{};
  for (const JointId j : chain.joints()) best[j] = random.uniform(chain.link(j).lower, chain.link(j).upper);
  double value = chain.speed(best, both), step = 0.5;
  for (int i = 0; i < tries; ++i) {
    JointArray next = best;
    for (const JointId j : chain.joints())
      next[j] = std::clamp(next[j] + step * random.gaussian(), chain.link(j).lower, chain.link(j).upper);
    const double now = chain.speed(next, both);
    step = now > value ? std::min(1.0, step * 1.5) : std::max(1e-3, step * 0.97);
    if (now > value) {
      value = now;
      best = next;
    }
  }
  return value;
}

}  // namespace

FastestFoot fastestFoot(const RobotModel& model, int starts, unsigned seed) {
  Chain chain(model);
  Random random(seed);
  FastestFoot fastest;
  for (int i = 0; i < starts; ++i) {
    fastest.wholeChain = std::max(fastest.wholeChain, climb(chain, true, random));
    fastest.kickingLeg = std::max(fastest.kickingLeg, climb(chain, false, random));
  }
  return fastest;
}

}  // namespace plumbline::bench
