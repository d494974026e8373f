#include "motion/Keyframes.h"

#include <algorithm>

namespace plumbline::motion {

double KeyframeMotion::seconds() const {
  double sum = 0;
  for (const Keyframe& keyframe : keyframes) sum += keyframe.seconds;
  return sum;
}

JointId mirrored(JointId joint) {
  if (joint >= lShoulderPitch && joint <= lElbowRoll)
    return static_cast<JointId>(joint + (rShoulderPitch - lShoulderPitch));
  if (joint >= rShoulderPitch && joint <= rElbowRoll)
    return static_cast<JointId>(joint - (rShoulderPitch - lShoulderPitch));
  if (joint >= lHipYawPitch && joint <= lToePitch)
    return static_cast<JointId>(joint + (rHipYawPitch - lHipYawPitch));
  if (joint >= rHipYawPitch && joint <= rToePitch)
    return static_cast<JointId>(joint - (rHipYawPitch - lHipYawPitch));
  return joint;
}

double mirrorSign(JointId joint) {
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
    for (int j = 0; j < numJoints; ++j) {
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
