#pragma once
#include <functional>
#include <memory>
#include <string>

#include "simulation/league/MakeWorld.h"

namespace plumbline::training {

/// Where a kicked ball comes to rest: it flies and rolls on in an empty world with the league's physics.
class BallRoll {
public:
  explicit BallRoll(const std::string& engine = "ode");
  /// From this state until it is slower than 2 cm/s, at most 20 s: where it then lies [m, world]. see: is
  /// shown its place in each cycle.
  Vec2 roll(const simulation::BodyState& ball, const std::function<void(const Vec3&)>& see = {});

private:
  std::unique_ptr<simulation::World> world_;
};

}  // namespace plumbline::training
