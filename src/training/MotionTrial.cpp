#include "training/MotionTrial.h"

#include <cmath>

#include "framework/StopSignal.h"
#include "math/Angle.h"

namespace plumbline::training {
namespace {

// Of a robot that is pushed.
constexpr double fastest = 0.6, fastestTurn = 0.5;          // [m/s, rad/s]
constexpr double leastPush = 0.6, mostPush = 1.6;           // change of its speed [m/s]
constexpr double pushAside = 0.6;                           // of the push's direction [rad]
constexpr int leastSteps = 30, mostSteps = 80, wait = 150;  // before and after it [cycles]

}  // namespace

MotionTrial::MotionTrial(int type, const simulation::WorldConfig& config)
    : MotionDriver(type), robot(model, config), control(model) {
  robot.restart(Pose2(), stand);
  lastAngles_ = robot.sense().angle;
  standingHeight = height();
}

void MotionTrial::move(const JointArray& targets) {
  StopSignal::throwIfCaught();  // a try may take seconds
  lastAngles_ = robot.sense().angle;
  JointArray measured = lastAngles_;
  for (double& angle : measured) angle = std::round(angle * 18000 / pi) / (18000 / pi);
  robot.act(control.update(measured, targets, dt));
}

JointArray MotionTrial::rates() const {
  JointArray rates{};
  for (std::size_t j = 0; j < maxJoints; ++j) rates[j] = (robot.sense().angle[j] - lastAngles_[j]) / dt;
  return rates;
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

bool MotionTrial::stumble(int direction) {
  robot.restart(Pose2(), stand);
  restarted();
  const double way = random(-pi, pi), speed = random(0, fastest), turn = random(-fastestTurn, fastestTurn);
  const Vec2 velocity = speed * Vec2(std::cos(way), std::sin(way));
  for (int i = static_cast<int>(random(leastSteps, mostSteps)); i > 0; --i) walkStep(velocity, turn);
  if (lying()) return true;
  const double aside = random(0, 1) < 0.5 ? -pi / 2 : pi / 2;
  const double along = (direction > 0 ? 0 : direction < 0 ? pi : aside) + random(-pushAside, pushAside);
  const double push = random(leastPush, mostPush);
  simulation::BodyState torso = robot.torso();
  const Vec3 ahead = torso.pose.linear() * Vec3(std::cos(along), std::sin(along), 0);
  torso.linearVelocity += push * ahead;
  torso.angularVelocity += push / standingHeight * Vec3::UnitZ().cross(ahead);  // it tips over its feet
  robot.world().setVelocities(robot.robot(), torso, rates());
  for (int i = 0; i < wait && !lying(); ++i) walkStep(velocity, turn);
  return lying();
}

void MotionTrial::State::stop() {
  torso.linearVelocity = torso.angularVelocity = Vec3::Zero();
  rates.fill(0);
}

void MotionTrial::begin(const State& state) {
  robot.restart(state.torso.pose, state.angles);
  robot.world().setVelocities(robot.robot(), state.torso, state.rates);
  restarted();
}

void MotionTrial::restarted() {
  lastAngles_ = robot.sense().angle;
  control.reset();
  forget();
}

}  // namespace plumbline::training
