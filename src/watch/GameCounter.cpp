#include "watch/GameCounter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::watch {

using simspark::SceneRobot;
using simspark::SceneState;
using simspark::TeamSide;

namespace {
constexpr double leastCosineUpright = 0.9, mostCosineLying = 0.5;  ///< of the torso's tilt

/// Rounded as the recordings of a game are, so that page and table count the same.
double centimetres(double metres) { return std::round(100 * metres) / 100; }

Vec2 placeOf(const Vec3& position) { return {centimetres(position.x()), centimetres(position.y())}; }
}  // namespace

void GameCounter::observe(const SceneState& scene) {
  const bool running = lastTime_ && scene.time > *lastTime_ && scene.playMode != "BeforeKickOff" &&
                       scene.playMode != "GameOver";
  countFalls(scene, running);
  countFouls(scene);
  countPasses(scene);
  if (running) {
    countKicks(scene);
  } else if (!lastTime_ || scene.time != *lastTime_ || scene.ball.head<2>() != lastBall_) {
    lastVelocity_.reset();
  }
  lastTime_ = scene.time;
  lastBall_ = scene.ball.head<2>();
}

void GameCounter::countFalls(const SceneState& scene, bool running) {
  std::array<int, 2> here{};
  for (const SceneRobot& robot : scene.robots) {
    if (robot.side == TeamSide::none || robot.unum == 0) continue;
    ++here[index(robot.side)];
    Stance& stance = stances_[{robot.side, robot.unum}];
    const double up = robot.T_world_torso.linear()(2, 2);
    if (up > leastCosineUpright) stance = {.stood = true, .fallen = false};
    if (up < mostCosineLying && stance.stood && !stance.fallen) {
      stance.fallen = true;
      if (running) ++falls_[index(robot.side)];
    }
  }
  for (std::size_t i = 0; i < here.size(); ++i) players_[i] = std::max(players_[i], here[i]);
}

void GameCounter::countFouls(const SceneState& scene) {
  std::set<Offence> offences;
  for (const simspark::SceneFoul& foul : scene.fouls) {
    const Offence offence{foul.side, foul.unum, foul.kind};
    if (offences.insert(offence).second && !lastOffences_.contains(offence))
      ++fouls_[index(foul.side)][static_cast<std::size_t>(foul.kind)];
  }
  lastOffences_ = std::move(offences);
  if (scene.playMode == lastMode_) return;
  lastMode_ = scene.playMode;
  if (lastMode_.ends_with("free_kick_left")) ++freeKicksAgainst_[index(TeamSide::right)];
  if (lastMode_.ends_with("free_kick_right")) ++freeKicksAgainst_[index(TeamSide::left)];
}

void GameCounter::countPasses(const SceneState& scene) {
  if (!touches_) touches_.emplace(scene.field.length / 2, scene.field.goalWidth / 2);
  BallMoment moment{.time = scene.time, .mode = scene.playMode, .ball = placeOf(scene.ball)};
  for (const SceneRobot& robot : scene.robots)
    moment.players.push_back({robot.side, robot.unum, placeOf(robot.T_world_torso.translation())});
  touches_->observe(std::move(moment));
}

void GameCounter::countKicks(const SceneState& scene) {
  const Vec2 ball = scene.ball.head<2>();
  const Vec2 velocity = (ball - lastBall_) / (scene.time - *lastTime_);
  const bool carried = velocity.norm() > maxBallSpeed;
  const std::optional<Vec2> before =
      std::exchange(lastVelocity_, carried ? std::nullopt : std::optional(velocity));
  if (carried || !before || velocity.norm() - before->norm() < kickGain || scene.time - lastKick_ < kickPause)
    return;
  const SceneRobot* kicker = nullptr;
  double nearest = kickReach;
  for (const SceneRobot& robot : scene.robots) {
    const double distance = (robot.T_world_torso.translation().head<2>() - lastBall_).norm();
    if (robot.side == TeamSide::none || distance > nearest) continue;
    nearest = distance;
    kicker = &robot;
  }
  if (!kicker) return;
  lastKick_ = scene.time;
  ++kicks_[index(kicker->side)];
}

}  // namespace plumbline::watch
