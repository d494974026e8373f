#pragma once
#include "math/Types.h"

namespace plumbline::walking {

/// Everything about the walk that a user may set; each with unit and sensible range. The defaults make the
/// league's type 0 walk; config/robots/*/walking.yaml holds the values found for each robot.
struct WalkParameters {
  // Posture
  double hipHeight = 0.20;     ///< hip joints over the sole [m], 0.1 .. leg length
  double feetDistance = 0.11;  ///< between the soles' centres, walking on the spot [m], 0.09 .. 0.16
  double torsoPitch = 0.0;     ///< lean forward [rad], -0.1 .. 0.4

  // Rhythm and limits
  double stepDuration = 0.18;             ///< of one step on the spot [s], 0.12 .. 0.5
  double minStepDuration = 0.12;          ///< [s]
  double maxStepDuration = 0.30;          ///< [s]
  Vec2 maxVelocity = Vec2(0.6, 0.3);      ///< forward and sideways the walk accepts [m/s]
  double maxBackwardVelocity = 0.4;       ///< [m/s], positive
  double maxTurn = 1.6;                   ///< [rad/s]
  Vec2 maxAcceleration = Vec2(1.0, 1.0);  ///< of the requested velocity [m/s^2], 0.2 .. 5
  double maxTurnAcceleration = 6.0;       ///< [rad/s^2]
  double maxStepForward = 0.10;           ///< swing target before the centre of mass [m], 0.03 .. 0.15
  double maxStepBackward = 0.08;          ///< the same behind it [m]
  double maxStepOutward = 0.14;           ///< swing target beside the centre of mass [m]
  double minStepOutward = 0.045;          ///< the feet do not cross: half of the smallest distance [m]

  // Swing foot
  double stepHeight = 0.02;      ///< [m], 0.005 .. 0.06
  double swingStart = 0.0;       ///< share of the step before the swing foot moves over the ground, 0 .. 0.4
  double swingEnd = 1.0;         ///< share of the step when it has arrived, 0.6 .. 1
  double swingSmoothness = 0.5;  ///< 0: constant speed, 1: from rest to rest
  double swingSteepness = 1.5;   ///< of lifting and lowering: 1 a sine arch, 2 from rest to rest
  double swingPitch = 0.0;       ///< of the swing foot when highest, toes down [rad], -0.3 .. 0.3

  // Model: the pendulum
  double pendulumHeight = 0.25;   ///< of the centre of mass over the ground in the model [m], 0.15 .. 0.4
  Vec2 copOffset = Vec2::Zero();  ///< pressure on the supporting sole from its centre: forward, outward [m]

  // Start and stop
  double startDuration = 0.14;  ///< shift of the weight before the first step [s], 0.06 .. 0.4
  double stopVelocity = 0.05;   ///< the walk stops only below this forward velocity [m/s]

  // Feedback; all zero is the open loop
  Vec2 ankleGain =
      Vec2::Zero();  ///< of the torso's angle (roll, pitch) on the ankles of the supporting leg, 0 .. 1
  Vec2 gyroGain = Vec2::Zero();  ///< of the torso's turn rate (roll, pitch) on the same [s], 0 .. 0.1
  Vec2 stepGain =
      Vec2::Zero();  ///< share of the observed state's difference taken over per cycle (x, y), 0 .. 0.3

  // Arms
  double armSwing = 0.0;        ///< shoulder pitch per distance of the feet along x [rad/m], 0 .. 5
  double shoulderPitch = 1.57;  ///< [rad]
  double shoulderRoll = 0.25;   ///< outward [rad]
  double elbowYaw = 0.0;        ///< turned so that a bent elbow points outward [rad]
  double elbowRoll = 0.6;       ///< bent, inward [rad]

  // Odometry: walked over planned
  Vec2 odometryScale = Vec2::Ones();
  double odometryTurnScale = 1.0;

  /// Throws std::invalid_argument "walking parameter X = V must be ..." for the first one out of its range.
  void check() const;
};

}  // namespace plumbline::walking
