#include "training/tasks/WalkOn.h"

#include "motion/MotionDefaults.h"

namespace plumbline::training {

WalkOn::WalkOn(MotionDriver& driver, double seconds, double still)
    : driver_(driver),
      seconds_(seconds),
      after_(AfterMotion::drawn([&](double low, double high) { return driver.random(low, high); }, still)) {}

void WalkOn::begin(const JointArray& from, double fadeSeconds) {
  from_ = from;
  fade_ = after_.stands ? motion::standFade : fadeSeconds;
  error_ = 0;
  cycles_ = 0;
  driver_.beginWalk();
}

bool WalkOn::isOver() const { return cycles_ * MotionDriver::dt >= seconds_; }

void WalkOn::step() {
  JointArray targets =
      after_.stands ? driver_.stand : driver_.walkOutput(after_.velocity, after_.turn).angles;
  const double time = ++cycles_ * MotionDriver::dt;
  if (time < fade_)
    for (std::size_t j = 0; j < maxJoints; ++j)
      targets[j] = from_[j] + time / fade_ * (targets[j] - from_[j]);
  driver_.step(targets);
  error_ += driver_.tilt();
}

}  // namespace plumbline::training
