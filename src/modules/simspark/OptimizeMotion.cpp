#include "modules/simspark/OptimizeMotion.h"

#include <algorithm>
#include <cmath>

#include "field/FieldSize.h"
#include "math/Angle.h"
#include "math/GroundPose.h"
#include "trials/StandUpMeasure.h"
#include "trials/TaskOptions.h"

namespace plumbline {

MAKE_MODULE(OptimizeMotion)

namespace {

constexpr double radius = FieldSize().ballRadius;  ///< of the ball [m]
constexpr double sameBall = 0.03;       ///< a ball this near to where it was put has come there [m]
constexpr double patience = 3;          ///< with a command, then it is given again [s]
constexpr double mostBlind = 5;         ///< without ground truth [s]
constexpr double mostRoll = 0.01;       ///< way in half a second of a ball that rests [m]
constexpr double mostTiltBefore = 0.3;  ///< of a robot that stands before a try [rad]
constexpr double lieSeconds = 0.5;      ///< until one that fell lies still [s]
/// Nothing stands in the way of a ball that is kicked along the field from here, and the ball waits elsewhere
/// [m].
const Vec2 place(-10, 5);
const Vec2 aside(-10, -5);

}  // namespace

void OptimizeMotion::init() { monitor_ = &object<Monitor>(); }

double OptimizeMotion::tilt() const {
  return std::acos(std::clamp(theGroundTruth->T_field_torso.linear()(2, 2), -1.0, 1.0));
}

bool OptimizeMotion::selected() const {
  return theMotionSelection && theMotionSelection->motion == SearchedMotionOutput::name;
}

Pose2 OptimizeMotion::onField(const Pose2& own) const {
  return thePlayerInfo->leftSide ? own : Pose2(Vec2(-own.position), normalizeAngle(own.heading + pi));
}

bool OptimizeMotion::command(bool sent) {
  if (!sent) requestStop(2, "no trainer command reaches the simulator: " + monitor_->error());
  return sent;
}

void OptimizeMotion::enter(Phase phase) {
  phase_ = phase;
  seconds_ = lastAt_ = 0;
}

void OptimizeMotion::placeRobot() {
  milliseconds_ = error_ = lies_ = 0;
  walked_ = 0;
  // The ball goes along the field in any wanted direction: over a side line the referee would put it back.
  const Pose2 there = onField(Pose2(place, -direction_));
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

void OptimizeMotion::placeBall() {
  from_ = groundPose(theGroundTruth->T_field_torso);
  const double spread = kick_->spread;
  const double x = random_.uniform(-spread, spread), y = random_.uniform(-spread, spread);
  ball_ = from_ * Vec2(theSearchedMotionOutput->ball + Vec2(x, y));
  const Vec2 there = onField(Pose2(ball_, 0)).position;
  if (command(monitor_->moveBall(Vec3(there.x(), there.y(), radius)))) enter(Phase::ball);
}

/// Waits until the robot stands where it was put, and until the motions are free.
void OptimizeMotion::stand() {
  const bool there = (groundPose(theGroundTruth->T_field_torso).position - place).norm() < 0.5;
  const bool free = theMotionSelection && theMotionSelection->motion == Motion::stand;
  if (!there || !free || theFallState->lying() || tilt() > mostTiltBefore) {
    if (seconds_ > patience && !theFallState->lying()) placeRobot();
    return;
  }
  if (seconds_ < standSeconds || !theSearchedMotionOutput) return;
  kick_ ? placeBall() : enter(Phase::falling);
}

/// Waits until the robot lies as the task wants it; one that does not falls once more, in another way.
void OptimizeMotion::fall() {
  const Posture wanted = standUp_->side() > 0 ? Posture::onFront : Posture::onBack;
  if (theFallState->posture != wanted) {
    lies_ = 0;
    if (seconds_ > patience) placeRobot();
  } else if ((lies_ += theFrameInfo->cycleSeconds) >= lieSeconds) {
    enter(Phase::playing);
  }
}

void OptimizeMotion::play() {
  if (selected()) {
    milliseconds_ += 1e3 * theFrameInfo->cycleSeconds;
    if (!theMotionSelection->started && theSearchedMotionOutput->finished) enter(Phase::walking);
  } else if (seconds_ > patience) {
    placeRobot();  // it fell before it began
  }
}

void OptimizeMotion::walk() {
  error_ += tilt();
  if (++walked_ * theFrameInfo->cycleSeconds < (kick_ ? kick_->walk : StandUpOptions::walkSeconds)) return;
  up_ = AfterMotion::upright(tilt());
  if (standUp_) return finish(standUpOutcome(*standUp_, milliseconds_, error_, up_));
  last_ = theGroundTruth->ball.head<2>();
  enter(Phase::rolling);
}

void OptimizeMotion::roll() {
  const Vec2 now = theGroundTruth->ball.head<2>();
  if (seconds_ < rollSeconds) {
    if (seconds_ - lastAt_ < 0.5) return;
    const double way = (now - last_).norm();
    last_ = now;
    lastAt_ = seconds_;
    if (way > mostRoll) return;
  }
  finish(measure_->outcome({now, milliseconds_, error_, up_}));
}

void OptimizeMotion::begin() {
  const TaskOptions options = TaskOptions::ofLines(theOptimizationTrial->options);
  kick_.reset();
  standUp_.reset();
  if (theOptimizationTrial->task == "standUp")
    standUp_ = options.as<StandUpOptions>();
  else
    kick_ = options.as<KickOptions>();
  direction_ = kick_ ? fromDegrees(kick_->direction) : 0;
  random_ = Random(theOptimizationTrial->seed);
  after_ = AfterMotion::drawn([this](double low, double high) { return random_.uniform(low, high); },
                              kick_ ? kick_->still : standUp_->still);
  placeRobot();
}

void OptimizeMotion::finish(const TaskOutcome& outcome) {
  result_ = {};
  result_.number = theOptimizationTrial->number;
  result_.cost = outcome.cost;
  for (const auto& [name, value] : outcome.figures) {
    result_.figures.push_back(name);
    result_.values.push_back(value);
  }
  enter(Phase::waiting);
}

void OptimizeMotion::decide() {
  seconds_ += theFrameInfo->cycleSeconds;
  if (!theOptimizationTrial->open) return enter(Phase::waiting);
  if (theFrameInfo->restarted) enter(Phase::waiting);
  switch (phase_) {
    case Phase::waiting:
      return theOptimizationTrial->number == result_.number ? void() : begin();
    case Phase::standing:
      return stand();
    case Phase::ball:
      if ((theGroundTruth->ball.head<2>() - ball_).norm() < sameBall && seconds_ > 0.1) {
        measure_.emplace(*kick_, from_, ball_);
        enter(Phase::playing);
      } else if (seconds_ > patience) {
        placeRobot();
      }
      return;
    case Phase::falling:
      return fall();
    case Phase::playing:
      return play();
    case Phase::walking:
      return walk();
    case Phase::rolling:
      return roll();
  }
}

void OptimizeMotion::update(MotionRequest* theMotionRequest) {
  *theMotionRequest = {};
  if (theGroundTruth->valid && thePlayerInfo->number > 0) {
    blind_ = 0;
    if (kick_ && (phase_ == Phase::playing || phase_ == Phase::walking || phase_ == Phase::rolling))
      measure_->see(theGroundTruth->ball);
    decide();
  } else if ((blind_ += theFrameInfo->cycleSeconds) > mostBlind) {
    requestStop(2, "the simulator sends no ground truth: start it with --ground-truth");
  }
  // As in a worker, a robot that falls does not stand up before its try is over.
  theMotionRequest->staysDown =
      phase_ == Phase::falling || phase_ == Phase::playing || phase_ == Phase::walking;
  if (phase_ == Phase::falling) theMotionRequest->motion = FallOverOutput::name;
  if (phase_ == Phase::playing) theMotionRequest->motion = SearchedMotionOutput::name;
  if (phase_ == Phase::walking && !after_.stands) {
    theMotionRequest->motion = Motion::walk;
    theMotionRequest->walkVelocity = after_.velocity;
    theMotionRequest->walkTurn = after_.turn;
  }
}

}  // namespace plumbline
