#include "training/MotionTrial.h"

#include <cmath>

#include "math/Angle.h"

namespace plumbline::motion {

MotionTrial::MotionTrial(int type, const simulation::WorldConfig& config)
    : MotionDriver(type), robot(model, config), control(model) {
  robot.restart(Pose2(), stand);
  standingHeight = height();
}

void MotionTrial::move(const JointArray& targets) {
  JointArray measured = robot.sense().angle;
  for (double& angle : measured) angle = std::round(angle * 18000 / pi) / (18000 / pi);
  robot.act(control.update(measured, targets, dt));
}

bool MotionTrial::fall(int direction) {
  JointArray from = jitter(0.25), to = jitter(0.4);
  double pitch = direction * random(0.35, 1.45), roll = random(-0.35, 0.35);
  if (direction == 0) {
    pitch = random(-0.3, 0.3);
    roll = (random(0, 1) < 0.5 ? -1 : 1) * random(0.5, 1.4);
  }
  const double heading = random(-pi, pi);
  robot.restart(
      translation(0, 0, random(0.30, 0.42)) * rotationZ(heading) * rotationY(pitch) * rotationX(roll), from);
  restarted();
  const int rest = static_cast<int>(random(0, 10));
  for (int i = 0; i < 200 && !lying(); ++i) step(to);
  for (int i = 0; i < rest; ++i) step(to);
  return lying();
}

void MotionTrial::restarted() {
  control.reset();
  forget();
}

}  // namespace plumbline::motion
