#pragma once
#include <cmath>
#include <deque>
#include <optional>

#include "math/Pose2.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// Odometry from the commands, at the time at which they can be measured; or, if the feet show the velocity,
/// from the observation (odometry.observedShare).
class WalkOdometry {
public:
  void reset(const Pose2& T_com_torso) {
    torso_ = T_com_torso;
    underway_.clear();
  }
  /// Adds a cycle of dt [s]. The frame of the centre of mass moved by `motion`, with the torso's ground frame
  /// in it at the end. observed: the motion of the torso's ground frame in the last cycle, if it is known
  /// (WalkObserver::torsoMotion). Returns the motion of the torso's ground frame that has taken effect, in
  /// that frame.
  Pose2 update(const Pose2& motion, const Pose2& T_com_torso, bool walking, const WalkParameters& p,
               double dt, const std::optional<Pose2>& observed = std::nullopt) {
    Pose2 moved = torso_.inverse() * motion * T_com_torso;
    torso_ = T_com_torso;
    if (walking) moved.position.x() -= p.speed.trimForward * dt;
    moved.position = moved.position.cwiseProduct(Vec2(p.odometry.scaleForward, p.odometry.scaleSideways));
    moved.heading *= p.odometry.scaleTurn;
    underway_.push_back(moved);
    const auto delay = static_cast<std::size_t>(std::lround(p.odometry.delay / dt));
    Pose2 planned;
    for (; underway_.size() > delay; underway_.pop_front()) planned = planned * underway_.front();
    if (!observed) return planned;
    const double share = p.odometry.observedShare;
    return Pose2(Vec2(planned.position + share * (observed->position - planned.position)),
                 planned.heading + share * (observed->heading - planned.heading));
  }

private:
  Pose2 torso_;  ///< in the centre of mass frame, last cycle
  std::deque<Pose2> underway_;
};

}  // namespace plumbline::walking
