#include "motion/Keyframes.h"

#include <algorithm>

#include "framework/NearestName.h"

namespace plumbline::motion {

double KeyframeMotion::seconds() const {
  double sum = 0;
  for (const Keyframe& keyframe : keyframes) sum += keyframe.seconds;
  return sum;
}

const KeyframeMotion* findMotion(const std::vector<KeyframeMotion>& motions, const std::string& name) {
  const auto found = std::find_if(motions.begin(), motions.end(),
                                  [&](const KeyframeMotion& motion) { return motion.name == name; });
  return found == motions.end() ? nullptr : &*found;
}

std::string missingMotion(const std::vector<KeyframeMotion>& motions, const std::string& name) {
  std::vector<std::string> names;
  for (const KeyframeMotion& motion : motions) names.push_back(motion.name);
  return "there is no motion " + name + " in motions/" + suggestion(name, names);
}

JointId mirrored(JointId joint) {
  const auto exchanged = [joint](int left, int right) {
    const int count = right - left;
    if (joint >= left && joint < right) return static_cast<JointId>(joint + count);
    if (joint >= right && joint < right + count) return static_cast<JointId>(joint - count);
    return joint;
  };
  for (const OwnJointRange& range : ownJointRanges)
    if (range.pair && range.has(joint)) return exchanged(range.first, range.first + range.count / 2);
  const JointId arm = exchanged(lShoulderPitch, rShoulderPitch);
  return arm != joint ? arm : exchanged(lHipYawPitch, rHipYawPitch);
}

double mirrorSign(JointId joint) {
  for (const OwnJointRange& range : ownJointRanges)
    if (range.has(joint)) return range.signStays ? 1 : -1;
  switch (joint) {
    case headYaw:
    case lShoulderRoll:
    case rShoulderRoll:
    case lElbowYaw:
    case rElbowYaw:
    case lElbowRoll:
    case rElbowRoll:
    case lHipRoll:
    case rHipRoll:
    case lAnkleRoll:
    case rAnkleRoll:
      return -1;
    default:
      return 1;
  }
}

KeyframeMotion mirrored(const KeyframeMotion& motion) {
  KeyframeMotion result = motion;
  result.ball.y() = -motion.ball.y();
  if (result.kick) result.kick->direction = -motion.kick->direction;
  for (std::size_t i = 0; i < motion.keyframes.size(); ++i) {
    const Keyframe& from = motion.keyframes[i];
    Keyframe& to = result.keyframes[i];
    for (int j = 0; j < maxJoints; ++j) {
      const auto joint = static_cast<JointId>(j);
      to.angles[mirrored(joint)] = mirrorSign(joint) * from.angles[joint];
      to.set[mirrored(joint)] = from.set[joint];
    }
    for (BallGain& gain : to.ballGains) {
      gain.gain = mirrorSign(gain.joint) * Vec2(gain.gain.x(), -gain.gain.y());
      gain.joint = mirrored(gain.joint);
    }
  }
  return result;
}

KeyframeMotion shiftedToBall(const KeyframeMotion& motion, const Vec2& ball) {
  const Vec2 offset = (ball - motion.ball).cwiseMax(-motion.ballReach).cwiseMin(motion.ballReach);
  KeyframeMotion result = motion;
  for (Keyframe& keyframe : result.keyframes)
    for (const BallGain& gain : keyframe.ballGains) keyframe.angles[gain.joint] += gain.gain.dot(offset);
  return result;
}

}  // namespace plumbline::motion
