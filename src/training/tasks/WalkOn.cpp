#include "training/tasks/WalkOn.h"

#include <cmath>

#include "math/Angle.h"

namespace plumbline::training {
namespace {

constexpr double walkSpeed = 0.3, walkTurn = 0.5;  // [m/s, rad/s]
constexpr double fadeToStand = 0.14;               // StandMotion's [s]
constexpr double leaning = 30 * pi / 180;          // [rad], of the thesis's measure

}  // namespace

WalkOn::WalkOn(motion::MotionTrial& trial, double seconds, double still) : trial_(trial), seconds_(seconds) {
  const double way = trial.random(-pi, pi);
  turn_ = trial.random(-walkTurn, walkTurn);
  velocity_ = walkSpeed * Vec2(std::cos(way), std::sin(way));
  stands_ = still > 0 && trial.random(0, 1) < still;
}

void WalkOn::begin(const JointArray& from, double fadeSeconds) {
  from_ = from;
  fade_ = stands_ ? fadeToStand : fadeSeconds;
  error_ = 0;
  cycles_ = 0;
  trial_.beginWalk();
}

bool WalkOn::isOver() const { return cycles_ * motion::MotionTrial::dt >= seconds_; }

bool WalkOn::upright() const { return trial_.tilt() < leaning; }

void WalkOn::step() {
  JointArray targets = stands_ ? trial_.stand : trial_.walkOutput(velocity_, turn_).angles;
  const double time = ++cycles_ * motion::MotionTrial::dt;
  if (time < fade_)
    for (std::size_t j = 0; j < maxJoints; ++j)
      targets[j] = from_[j] + time / fade_ * (targets[j] - from_[j]);
  trial_.step(targets);
  error_ += trial_.tilt();
}

}  // namespace plumbline::training
