#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/Types.h"
#include "robot/JointId.h"
#include "robot/KickEffect.h"

namespace plumbline::motion {

/// How a joint's angle moves with the place of the ball, for kicks: angle += gain . (ball - nominal ball).
struct BallGain {
  JointId joint = noJoint;
  Vec2 gain = Vec2::Zero();  ///< [rad/m], along x (forward) and y (left) of the robot's ground frame
};

/// A posture and the time to reach it from the one before, joint by joint in a straight line.
struct Keyframe {
  double seconds = 0;        ///< from the previous keyframe to this one [s]; 0: as fast as the joints can
  double settleSeconds = 0;  ///< then wait until the torso is still, this long at most [s]
  JointArray angles{};       ///< [rad]
  JointFlags set{};          ///< joints without an angle stay where the last keyframe put them
  std::vector<BallGain> ballGains;
};

/// A motion as a list of keyframes.
struct KeyframeMotion {
  std::string name;
  std::vector<Keyframe> keyframes;
  Vec2 ball = Vec2::Zero();       ///< where a kick expects the ball, robot's ground frame [m]
  Vec2 ballReach = Vec2::Zero();  ///< how far from there it may lie [m]; 0: the motion does not mind the ball
  std::optional<KickEffect> kick;  ///< of a motion that is chosen as a kick

  /// Time without waiting to settle [s].
  double seconds() const;
};

/// The motion of that name, or null.
const KeyframeMotion* findMotion(const std::vector<KeyframeMotion>& motions, const std::string& name);
/// Error text for an unknown name, with the nearest existing one.
std::string missingMotion(const std::vector<KeyframeMotion>& motions, const std::string& name);

/// The same joint of the other side; joints in the middle (head, waist) stay.
JointId mirrored(JointId joint);
/// +1 if a mirrored posture has the same sign in the mirrored joint, else -1 (yaw and roll).
double mirrorSign(JointId joint);
/// Left and right exchanged, the ball's y too.
KeyframeMotion mirrored(const KeyframeMotion& motion);

/// The keyframes for a ball at that place: each gain applied to the offset, which is clamped to ballReach.
KeyframeMotion shiftedToBall(const KeyframeMotion& motion, const Vec2& ball);

}  // namespace plumbline::motion
