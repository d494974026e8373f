#pragma once
#include <functional>
#include <memory>
#include <string>

#include "simulation/league/MakeWorld.h"

namespace plumbline::training {

/// Where a kicked ball comes to rest: it flies and rolls on in an empty world with the league's physics.
class BallRoll {
public:
  struct Rest {
    Vec2 place = Vec2::Zero();  ///< [m, world]
    double height = 0;          ///< greatest of its centre on the way [m]
  };

  explicit BallRoll(const std::string& engine = "ode");
  /// From this state until it is slower than 2 cm/s, at most 20 s. see: is shown its place in each cycle.
  Rest roll(const simulation::BodyState& ball, const std::function<void(const Vec3&)>& see = {});

private:
  std::unique_ptr<simulation::World> world_;
};

}  // namespace plumbline::training
