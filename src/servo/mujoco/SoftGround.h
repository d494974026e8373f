#pragma once
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::servo::mujoco {

/// Soft ground: a spring and a damper under each corner of each sole, and friction that sticks until it slips
/// (Cundall and Strack 1979).
class SoftGround {
public:
  /// compliance per corner [m/N]; `slope`: rotation of the ground in the world.
  SoftGround(const Mechanism& robot, double compliance, double friction, const Mat3& slope);

  struct Corner {
    int foot = 0, link = 0;
    Vec3 local = Vec3::Zero();   ///< link frame [m]
    Vec3 force = Vec3::Zero();   ///< on the robot, world axes [N]
    double normal = 0;           ///< [N]
    Vec3 anchor = Vec3::Zero();  ///< where friction holds it
    bool touches = false;
  };
  std::vector<Corner>& corners() { return list_; }
  /// Force on a corner at a place in the world, moving so.
  void update(Corner& corner, const Vec3& place, const Vec3& speed);

private:
  std::vector<Corner> list_;
  double stiffness_, damping_, friction_, sideStiffness_, sideDamping_;
  Vec3 up_;
};

}  // namespace plumbline::servo::mujoco
