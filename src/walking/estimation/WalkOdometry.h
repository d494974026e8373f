#pragma once
#include <cmath>
#include <deque>
#include <optional>

#include "math/Pose2.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// Odometry of what is commanded, told when it can be measured; or, where the velocity is known from the
/// feet, of what was observed (odometry.observedShare).
class WalkOdometry {
public:
  void reset(const Pose2& T_com_torso) {
    torso = T_com_torso;
    underway.clear();
  }
  /// A cycle of dt [s] in which the frame of the centre of mass moved by `motion`, with the torso's ground
  /// frame in it at the end; observed: the motion of the torso's ground frame in the last cycle, where it is
  /// known (WalkObserver::torsoMotion). Returns the motion of the torso's ground frame that has taken effect,
  /// in that frame.
  Pose2 update(const Pose2& motion, const Pose2& T_com_torso, bool walking, const WalkParameters& p,
               double dt, const std::optional<Pose2>& observed = std::nullopt) {
    Pose2 moved = torso.inverse() * motion * T_com_torso;
    torso = T_com_torso;
    if (walking) moved.position.x() -= p.speed.trimForward * dt;
    moved.position = moved.position.cwiseProduct(Vec2(p.odometry.scaleForward, p.odometry.scaleSideways));
    moved.heading *= p.odometry.scaleTurn;
    underway.push_back(moved);
    const auto delay = static_cast<std::size_t>(std::lround(p.odometry.delay / dt));
    Pose2 told;
    for (; underway.size() > delay; underway.pop_front()) told = told * underway.front();
    if (!observed) return told;
    const double share = p.odometry.observedShare;
    return Pose2(Vec2(told.position + share * (observed->position - told.position)),
                 told.heading + share * (observed->heading - told.heading));
  }

private:
  Pose2 torso;  ///< in the centre of mass frame, last cycle
  std::deque<Pose2> underway;
};

}  // namespace plumbline::walking
