#pragma once
#include <string>

#include "framework/Representation.h"
#include "math/Pose2.h"
#include "representations/motion/Motion.h"
#include "robot/JointId.h"

namespace plumbline {

/// What the motions shall do.
REPRESENTATION(MotionRequest)
class MotionRequest : public MotionRequestBase {
public:
  std::string motion = Motion::stand;  ///< name of a MotionOutput
  Vec2 walkVelocity = Vec2::Zero();    ///< in the robot's frame [m/s]
  double walkTurn = 0;                 ///< [rad/s]
  std::string specialAction;           ///< name of a keyframe file without its ending
  bool atOnce = false;                 ///< the motion does not wait until a walk stands
  bool staysDown = false;              ///< a robot that lies does what is asked; else it stands up first
  std::string kick;                    ///< the same of a motion that is a kick; empty: the shortest
  Side kickFoot = Side::right;
  Vec2 kickBall = Vec2::Zero();  ///< the ball relative to the robot at the moment of the request [m]
  void stream(InStream* in, OutStream* out) override {
    STREAM(motion);
    STREAM(walkVelocity);
    STREAM(walkTurn);
    STREAM(specialAction);
    STREAM(atOnce);
    STREAM(staysDown);
    STREAM(kick);
    STREAM(kickFoot);
    STREAM(kickBall);
  }
};

}  // namespace plumbline
