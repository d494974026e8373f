#include "watch/GameTrack.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace plumbline::watch {

using simspark::SceneRobot;
using simspark::TeamSide;

namespace {

void check(const std::ofstream& out, const std::string& file) {
  if (!out) throw std::runtime_error("cannot write " + file + ": " + std::strerror(errno));
}

}  // namespace

GameTrack::GameTrack(const std::string& file) : file_(file), out_(file) {
  out_ << "time,side,number,x,y,up,mode\n";
  check(out_, file_);
}

void GameTrack::observe(const simspark::SceneState& scene) {
  const bool runs = scene.time > before_;
  before_ = scene.time;
  if (!runs || scene.time < next_) return;
  next_ = (std::floor(scene.time / interval) + 1) * interval;
  out_ << fmt::format("{:.2f},ball,0,{:.2f},{:.2f},0,{}\n", scene.time, scene.ball.x(), scene.ball.y(),
                      scene.playMode);
  for (const SceneRobot& robot : scene.robots) {
    if (robot.side == TeamSide::none || robot.unum == 0) continue;
    const Vec3 place = robot.T_world_torso.translation();
    out_ << fmt::format("{:.2f},{},{},{:.2f},{:.2f},{:.2f},{}\n", scene.time,
                        robot.side == TeamSide::left ? "left" : "right", robot.unum, place.x(), place.y(),
                        robot.T_world_torso.linear()(2, 2), scene.playMode);
  }
  out_.flush();
  check(out_, file_);
}

}  // namespace plumbline::watch
