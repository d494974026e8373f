#pragma once
#include <span>
#include <vector>

#include "math/Pose2.h"
#include "math/Types.h"

namespace plumbline {

/// Motion of the torso over the ground from its orientation, the leg's kinematics and the feet's contact
/// points, which are taken to stand still on the ground from one cycle to the next.
class SupportOdometry {
public:
  /// A point of the robot that touches the ground: link, point in the link's frame [m], weight (its load)
  /// [N].
  struct Contact {
    int link = 0;
    Vec3 point = Vec3::Zero();
    double load = 0;
  };

  /// Without contact the last speed is kept for airborneSeconds, then the robot counts as lying still [s].
  explicit SupportOdometry(double airborneSeconds = 0.2) : airborneSeconds_(airborneSeconds) {}

  void setAirborneSeconds(double seconds) { airborneSeconds_ = seconds; }
  void reset();

  /// One cycle; R_world_torso: z up, T_torso_link: kinematics of this cycle, contacts: during the step that
  /// led to it. Returns T_before_now of the ground frame (below the torso, x the torso's heading); identity
  /// in the first cycle.
  Pose2 update(const Mat3& R_world_torso, std::span<const Pose3> T_torso_link,
               std::span<const Contact> contacts, double dt);

private:
  double airborneSeconds_;
  bool started_ = false;
  Mat3 R_before_ = Mat3::Identity();
  std::vector<Pose3> linksBefore_;
  double airborneFor_ = 0;
  Vec2 speed_ = Vec2::Zero();  ///< in the world's orientation [m/s]
};

}  // namespace plumbline
