#pragma once
#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <vector>

#include "math/Types.h"
#include "robot/Mechanism.h"

namespace plumbline::servo::mujoco {

/// MuJoCo's model and state with the addresses of a robot's parts.
class World {
public:
  /// Throws std::runtime_error with the engine's words where it refuses the text.
  World(const Mechanism& robot, const std::string& text);

  struct Address {
    int position = 0, velocity = 0;            ///< of the link's joint
    int rotorPosition = 0, rotorVelocity = 0;  ///< of the rotor's; the link's where there is none
  };
  const Address& joint(std::size_t j) const { return joints_[j]; }
  int body(std::size_t link) const { return bodies_[link]; }
  Pose3 pose(std::size_t link) const;
  /// Velocity of a place (world) that moves with a link.
  Vec3 velocity(std::size_t link, const Vec3& place) const;

  struct FootForce {
    double normal = 0;           ///< [N]
    Vec2 moment = Vec2::Zero();  ///< sum of place times normal, link frame [N m]
  };
  /// What the engine's contacts press on a sole.
  FootForce footForce(const std::string& foot, std::size_t link) const;

  mjModel* model() const { return m_.get(); }
  mjData* data() const { return d_.get(); }

private:
  std::unique_ptr<mjModel, void (*)(mjModel*)> m_;
  std::unique_ptr<mjData, void (*)(mjData*)> d_;
  std::vector<Address> joints_;
  std::vector<int> bodies_;
};

}  // namespace plumbline::servo::mujoco
