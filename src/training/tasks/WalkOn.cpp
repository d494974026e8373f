#include "training/tasks/WalkOn.h"

#include <cmath>

#include "math/Angle.h"
#include "motion/MotionDefaults.h"

namespace plumbline::training {
namespace {

constexpr double walkSpeed = 0.3, walkTurn = 0.5;  // [m/s, rad/s]
constexpr double leaning = 30 * pi / 180;          // [rad], of the thesis's measure

}  // namespace

WalkOn::WalkOn(MotionDriver& driver, double seconds, double still) : driver_(driver), seconds_(seconds) {
  const double way = driver.random(-pi, pi);
  turn_ = driver.random(-walkTurn, walkTurn);
  velocity_ = walkSpeed * Vec2(std::cos(way), std::sin(way));
  stands_ = still > 0 && driver.random(0, 1) < still;
}

void WalkOn::begin(const JointArray& from, double fadeSeconds) {
  from_ = from;
  fade_ = stands_ ? motion::standFade : fadeSeconds;
  error_ = 0;
  cycles_ = 0;
  driver_.beginWalk();
}

bool WalkOn::isOver() const { return cycles_ * MotionDriver::dt >= seconds_; }

bool WalkOn::upright() const { return driver_.tilt() < leaning; }

void WalkOn::step() {
  JointArray targets = stands_ ? driver_.stand : driver_.walkOutput(velocity_, turn_).angles;
  const double time = ++cycles_ * MotionDriver::dt;
  if (time < fade_)
    for (std::size_t j = 0; j < maxJoints; ++j)
      targets[j] = from_[j] + time / fade_ * (targets[j] - from_[j]);
  driver_.step(targets);
  error_ += driver_.tilt();
}

}  // namespace plumbline::training
