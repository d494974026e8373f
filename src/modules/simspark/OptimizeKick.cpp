#include "modules/simspark/OptimizeKick.h"

#include <algorithm>
#include <cmath>

#include "field/FieldSize.h"
#include "math/Angle.h"
#include "math/GroundPose.h"

namespace plumbline {

MAKE_MODULE(OptimizeKick)

namespace {

constexpr double radius = FieldSize().ballRadius;  ///< of the ball [m]
constexpr double sameBall = 0.03;                ///< a ball this near to where it was put has come there [m]
constexpr double patience = 3;                   ///< with a command, then it is given again [s]
constexpr double mostBlind = 5;                  ///< without ground truth [s]
constexpr double mostRoll = 0.01;                ///< way in half a second of a ball that rests [m]
constexpr double mostTiltAfter = 30 * pi / 180;  ///< of a robot that stands after the kick [rad]
constexpr double mostTiltBefore = 0.3;           ///< of one that stands before it [rad]
/// Nothing stands in the way of a ball that is kicked forward from here; the ball waits elsewhere [m].
const Pose2 place(Vec2(-10, 5), 0);
const Vec2 aside(-10, -5);

}  // namespace

void OptimizeKick::init() { monitor_ = &object<Monitor>(); }

double OptimizeKick::tilt() const {
  return std::acos(std::clamp(theGroundTruth->T_field_torso.linear()(2, 2), -1.0, 1.0));
}

bool OptimizeKick::selected() const {
  return theMotionSelection && theMotionSelection->motion == SearchedMotionOutput::name;
}

Pose2 OptimizeKick::onField(const Pose2& own) const {
  return thePlayerInfo->leftSide ? own : Pose2(Vec2(-own.position), normalizeAngle(own.heading + pi));
}

bool OptimizeKick::command(bool sent) {
  if (!sent) requestStop(2, "no trainer command reaches the simulator: " + monitor_->error());
  return sent;
}

void OptimizeKick::enter(Phase phase) {
  phase_ = phase;
  seconds_ = lastAt_ = 0;
}

void OptimizeKick::placeRobot() {
  const Pose2 there = onField(place);
  const Vec2 ball = onField(Pose2(aside, 0)).position;
  const simspark::TeamSide side =
      thePlayerInfo->leftSide ? simspark::TeamSide::left : simspark::TeamSide::right;
  // The half never ends.
  if (command(monitor_->send(simspark::TimeCommand{0})) &&
      command(monitor_->setPlayMode(simspark::PlayMode::playOn)) &&
      command(monitor_->moveBall(Vec3(ball.x(), ball.y(), radius))) &&
      command(monitor_->moveRobot(side, thePlayerInfo->number, there)))
    enter(Phase::standing);
}

void OptimizeKick::placeBall() {
  from_ = groundPose(theGroundTruth->T_field_torso);
  const double spread = theOptimizationTrial->spread;
  const double x = random_.uniform(-spread, spread), y = random_.uniform(-spread, spread);
  ball_ = from_ * Vec2(theSearchedMotionOutput->ball + Vec2(x, y));
  const Vec2 there = onField(Pose2(ball_, 0)).position;
  if (command(monitor_->moveBall(Vec3(there.x(), there.y(), radius)))) enter(Phase::ball);
}

/// Waits until the robot stands where it was put, and until the motions are free.
void OptimizeKick::stand() {
  const bool there = (groundPose(theGroundTruth->T_field_torso).position - place.position).norm() < 0.5;
  const bool free = theMotionSelection && theMotionSelection->motion == Motion::stand;
  if (!there || !free || theFallState->lying() || tilt() > mostTiltBefore) {
    if (seconds_ > patience && !theFallState->lying()) placeRobot();
    return;
  }
  if (seconds_ >= standSeconds && theSearchedMotionOutput) placeBall();
}

void OptimizeKick::kick() {
  if (selected()) {
    try_.milliseconds += 1e3 * theFrameInfo->cycleSeconds;
    if (!theMotionSelection->started && theSearchedMotionOutput->finished) enter(Phase::walking);
  } else if (seconds_ > patience) {
    placeRobot();  // it fell before it began
  }
}

void OptimizeKick::walk() {
  try_.error += tilt();
  if (seconds_ < walkSeconds) return;
  result_.up = tilt() < mostTiltAfter;
  last_ = theGroundTruth->ball.head<2>();
  enter(Phase::rolling);
}

void OptimizeKick::roll() {
  const Vec2 now = theGroundTruth->ball.head<2>();
  if (seconds_ < rollSeconds) {
    if (seconds_ - lastAt_ < 0.5) return;
    const double way = (now - last_).norm();
    last_ = now;
    lastAt_ = seconds_;
    if (way > mostRoll) return;
  }
  try_.way = Eigen::Rotation2Dd(-from_.heading) * (now - ball_);
  const OptimizationTrial& trial = *theOptimizationTrial;
  result_.number = trial.number;
  result_.cost = motion::KickWish{trial.distance, trial.weight, trial.steady}.cost(try_);
  result_.distance = try_.way.x();
  result_.direction = toDegrees(try_.direction());
  result_.time = try_.milliseconds;
  result_.error = try_.error;
  enter(Phase::waiting);
}

void OptimizeKick::decide() {
  seconds_ += theFrameInfo->cycleSeconds;
  if (!theOptimizationTrial->open) return enter(Phase::waiting);
  if (theFrameInfo->restarted) enter(Phase::waiting);
  switch (phase_) {
    case Phase::waiting:
      if (theOptimizationTrial->number == result_.number) return;
      random_ = Random(theOptimizationTrial->seed);
      walkWay_ = random_.uniform(-pi, pi);
      walkTurn_ = random_.uniform(-0.5, 0.5);
      return placeRobot();
    case Phase::standing:
      return stand();
    case Phase::ball:
      if ((theGroundTruth->ball.head<2>() - ball_).norm() < sameBall && seconds_ > 0.1) {
        try_ = {};
        enter(Phase::kicking);
      } else if (seconds_ > patience) {
        placeRobot();
      }
      return;
    case Phase::kicking:
      return kick();
    case Phase::walking:
      return walk();
    case Phase::rolling:
      return roll();
  }
}

void OptimizeKick::update(MotionRequest* theMotionRequest) {
  *theMotionRequest = {};
  if (theGroundTruth->valid && thePlayerInfo->number > 0) {
    blind_ = 0;
    if (phase_ == Phase::kicking || phase_ == Phase::walking || phase_ == Phase::rolling)
      try_.height = std::max(try_.height, theGroundTruth->ball.z() - radius);
    decide();
  } else if ((blind_ += theFrameInfo->cycleSeconds) > mostBlind) {
    requestStop(2, "the simulator sends no ground truth: start it with --ground-truth");
  }
  if (phase_ == Phase::kicking) theMotionRequest->motion = SearchedMotionOutput::name;
  if (phase_ == Phase::walking) {
    theMotionRequest->motion = Motion::walk;
    theMotionRequest->walkVelocity = walkSpeed * Vec2(std::cos(walkWay_), std::sin(walkWay_));
    theMotionRequest->walkTurn = walkTurn_;
  }
}

}  // namespace plumbline
