#include "training/tasks/BallRoll.h"

namespace plumbline::training {
namespace {

constexpr double atRest = 0.02;    // [m/s]
constexpr int mostCycles = 1000;   // of 20 ms
constexpr double touching = 0.05;  // height of the centre of a ball that is not in the air [m]

simulation::WorldConfig worldOn(const std::string& engine) {
  simulation::WorldConfig config;
  config.engine = engine;
  return config;
}

}  // namespace

BallRoll::BallRoll(const std::string& engine) : world_(simulation::makeWorld(worldOn(engine))) {}

Vec2 BallRoll::roll(const simulation::BodyState& ball, const std::function<void(const Vec3&)>& see) {
  world_->reset();
  world_->setBall(ball);
  for (int i = 0; i < mostCycles; ++i) {
    const simulation::BodyState now = world_->ball();
    const double height = now.pose.translation().z();
    if (see) see(now.pose.translation());
    if (now.linearVelocity.norm() < atRest && height < touching) break;
    world_->step();
  }
  return world_->ball().pose.translation().head<2>();
}

}  // namespace plumbline::training
