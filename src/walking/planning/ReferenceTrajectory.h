#pragma once
#include "walking/model/WalkModel.h"

namespace plumbline::walking {

/// A walk that shall be kept up.
struct Gait {
  Vec2 velocity = Vec2::Zero();  ///< mean, in the frame of the centre of mass [m/s]
  double turn = 0;               ///< [rad/s]
  double stepDuration = 0.2;     ///< [s]
  double feetDistance = 0.11;    ///< between the soles' centres, on the spot [m]
  Vec2 copOffset =
      Vec2::Zero();  ///< where the sole shall be pressed, from its centre, forward and outward [m]
};

/// The periodic walk of a gait (section 4.2.2): two steps that lead back to the state they began in.
struct ReferenceTrajectory {
  std::array<WalkState, 2> begin;    ///< when the left, right foot begins to carry
  std::array<WalkAction, 2> action;  ///< the step on the left, right foot
  int iterations = 0;                ///< evaluations of both steps that were needed
  double error = 0;                  ///< |velocity after two steps - velocity before| [m/s]
};

/// Algorithm 1 of the thesis, with a gradient that also knows rotation so that turning needs no more
/// iterations.
ReferenceTrajectory findReferenceTrajectory(const WalkModel& model, const Gait& gait);

/// Motion at constant velocity and turn rate for a time, in the frame at its start.
Pose2 arc(const Vec2& velocity, double turn, double time);

}  // namespace plumbline::walking
