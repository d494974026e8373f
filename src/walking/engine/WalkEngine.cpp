#include "walking/engine/WalkEngine.h"

#include <algorithm>
#include <cmath>

#include "robot/BodyJoints.h"
#include "walking/engine/BodyCommand.h"
#include "walking/estimation/ClosedLoop.h"
#include "walking/estimation/Disturbance.h"
#include "walking/estimation/FallGuard.h"
#include "walking/estimation/PerceivedState.h"
#include "walking/estimation/SpeedScale.h"
#include "walking/estimation/SupportSwitch.h"
#include "walking/estimation/TorsoTilt.h"
#include "walking/estimation/WalkOdometry.h"
#include "walking/model/LinearInvertedPendulum.h"
#include "walking/planning/Approach.h"
#include "walking/planning/KickRequest.h"
#include "walking/planning/KickStep.h"
#include "walking/planning/SpeedControl.h"
#include "walking/planning/StepPlanner.h"
#include "walking/planning/SwingTrajectory.h"
#include "walking/planning/TurnToStop.h"

namespace plumbline::walking {

class WalkEngine::Implementation {
public:
  Implementation(const WalkGaits& given, const RobotModel& robot)
      : gaits(given),
        p(gaits.base),
        loop(robot),
        model_(p.model.pendulumHeight),
        body_(robot),
        planner_(model_, {}) {
    reset();
  }

  void reset() {
    speed_.reset();
    stop_ = {};
    elapsed_ = phase_ = 0;
    useGait();
    mode_ = Mode::stand;
    kick_ = {};
    state = {};
    for (const Side side : {Side::left, Side::right})
      state.foot[index(side)] = Pose2(-p.model.copForward, outward(side) * p.posture.feetDistance / 2);
    tilt_ = {};
    contact_.reset();
    fall_.reset();
    disturbance.reset();
    motion_ = {};
    loop.reset();
    recorder.reset();
    body_.reset();
    place({});
    odometry_.reset(body_.torsoOnGround());
    standing_ = output({});
  }

  void forget() { scale_ = {}; }

  const WalkOutput& stand() const { return standing_; }
  WalkPlan plan() const { return {landing_, body_.torsoOnGround()}; }

  WalkOutput update(const WalkRequest& asked, const WalkSensors& sensors) {
    const WalkRequest request = withTarget(asked);
    follow(request, sensors.dt);
    tilt_.update(sensors, lean(), p);
    contact_.update(sensors);
    fall_.update(sensors.torsoAngles - Vec2(0, lean()), sensors.gyro.head<2>(), sensors.dt,
                 {.roll = p.fall.roll, .pitch = p.fall.pitch, .lead = p.fall.lead});
    motion_ = {};
    observe(sensors);
    advance(request, sensors.dt);
    loop.endCycle();
    place(sensors.angles);
    // At rest the velocity's noise is no motion.
    std::optional<Pose2> observed;
    if (sensors.feet && !(mode_ == Mode::stand && atRest())) observed = loop.observed().torsoMotion();
    return output(
        odometry_.update(motion_, body_.torsoOnGround(), mode_ == Mode::walk, p, sensors.dt, observed));
  }

  WalkOutput output(const Pose2& moved) const {
    WalkOutput out;
    out.angles = body_.angles();
    for (int j = firstBodyJoint; j < maxJoints; ++j) out.set[static_cast<std::size_t>(j)] = true;
    out.odometry = moved;
    out.support = state.support;
    out.phase = phase_;
    out.stepTarget = stepTarget_;
    out.stepTime = mode_ == Mode::walk ? stepTime_ : 0;
    out.kicking = kick_.now;
    out.kicked = kick_.done;
    out.stepsToTarget = stepsToTarget_;
    out.standing = mode_ == Mode::stand && atRest();
    out.velocity = speed_.velocity();
    out.turn = speed_.turn();
    out.stiffness =
        WalkOutput::legStiffness(p.servo.hipStiffness, p.servo.kneeStiffness, p.servo.ankleStiffness);
    out.falling = fall_.falling();
    if (out.falling) out.stiffness.fill(0);
    return out;
  }

  WalkGaits gaits;
  WalkParameters p;  ///< at the present speed
  WalkState state;
  ReferenceTrajectory reference;
  ClosedLoop loop;
  StepRecorder recorder;
  Disturbance disturbance;
  ModelParameters fit, prediction;

private:
  enum class Mode { stand, start, walk };

  /// A request for a target becomes one for a velocity or, there, for a stop or the kick.
  WalkRequest withTarget(WalkRequest request) {
    if (!request.kick) kick_ = {};
    stepsToTarget_ = 0;
    bool there = true;
    if (request.walk && request.target) {
      // The torso sways by some of this over its feet.
      constexpr ApproachTolerance arrived{.position = 0.025, .heading = 0.08};
      const ApproachPlan plan = planApproach(*request.target, speed_.velocity(), speed_.turn(), p, arrived);
      stepsToTarget_ = plan.steps.size();
      request.velocity = plan.velocity;
      request.turn = plan.turn;
      there = plan.steps.empty();
      if (there && (!request.kick || kick_.done)) request.walk = false;
    }
    if (request.walk && request.kick && there && !kick_.done && !kick_.prepared) kick_.foot = request.kick;
    return request;
  }

  /// The speed to plan with, so that the robot walks at the requested speed.
  Vec3 planned() const {
    return scale_.planned(speed_.all()) +
           Vec3(p.speed.trimForward + p.speed.brakeLead * speed_.braking(), 0, 0);
  }

  /// Moves the speed walked towards the request and finds its walk.
  void follow(const WalkRequest& request, double dt) {
    const double turn = stop_.turn(request.turn, request.walk, p, dt);
    if (mode_ == Mode::stand && !request.walk) {
      speed_.reset();
      useGait();
      return;
    }
    const Vec2 goal = request.walk ? request.velocity : Vec2(Vec2::Zero());
    if (mode_ == Mode::stand) speed_.begin(goal, p);
    const double calm = std::clamp(1 - p.feedback.tiltBrake * tilt_.excess.norm(), 0.0, 1.0);
    speed_.update(goal, turn, p, calm, dt);
    useGait();
    aim();
  }

  /// The walk of the speed aimed at.
  void aim() {
    const double duration = kick_.prepared ? p.kick.duration : p.step.duration;
    const Vec3 plan = planned();
    reference = findReferenceTrajectory(model_, {plan.head<2>(), plan.z(), duration, p.posture.feetDistance,
                                                 p.model.pressure() - model_.balance()});
  }

  /// The parameters of the speed walked now.
  void useGait() {
    p = gaits.at(speed_.velocity(), speed_.turn(), disturbance.share());
    model_ = LinearInvertedPendulum(p.model.heights(), p.model.pressure(), fit);
    StepLimits limits = stepLimits(p, body_.leg(Side::left));
    if (kick_.prepared) limits.maxDuration = std::max(limits.maxDuration, 1.2 * p.kick.duration);
    planner_.setLimits(limits);
    const auto& s = p.step;
    swing_ = {s.height, s.swingStart, s.swingEnd, s.swingSmoothness, s.swingSteepness};
  }

  /// Moves the walk state slowly towards the observed one (section 4.2.5).
  void observe(const WalkSensors& sensors) {
    const auto delay = static_cast<std::size_t>(std::lround(p.observation.delay / sensors.dt));
    const LinearInvertedPendulum observing(p.model.heights(), p.model.pressure(), prediction);
    const std::optional<WalkState> expected = loop.update(sensors, observing, delay, p.observation.imuWindow);
    if (!expected) return;
    recorder.add(loop.observed().state(), {p.model.heights(), p.model.pressure()}, sensors.dt);
    learnSpeed(sensors);
    disturbance.update(state, *expected, phase_, p.model.pendulumHeight, p, sensors.dt);
    // No more in a cycle than a foot may slide, or than the body can have tilted.
    const double most = 0.01 + 0.03 * disturbance.share();  // [m]
    const auto& gain = p.observation;
    const Vec2 step = disturbance.foot().cwiseProduct(Vec2(1, gain.positionGainLateral));
    const Vec2 shift = shortened(gain.positionGain * step, most);
    for (Pose2& foot : state.foot) foot.position += shift;
    motion_ = Pose2(Vec2(-shift));
    const Vec2 velocity = disturbance.velocity().cwiseProduct(Vec2(1, gain.velocityGainLateral));
    state.velocity += gain.velocityGain * velocity;
    if (mode_ == Mode::stand && !planner_.canHold(*expected, p.recovery.captureMargin)) captureStep();
  }

  /// Learns the speeds where the feet's forces show how the robot moves.
  void learnSpeed(const WalkSensors& sensors) {
    if (!sensors.feet || mode_ != Mode::walk || kick_.prepared || disturbance.share() > 0) return;
    const Pose2& moved = loop.observed().torsoMotion();
    scale_.update(speed_.all(), Vec3(moved.x(), moved.y(), moved.heading) / sensors.dt, p.speed.scaleWindow,
                  sensors.dt);
  }

  /// If standing cannot hold the robot: the foot on the capture point's side carries, the other steps.
  void captureStep() {
    speed_.reset();
    disturbance.begin();
    useGait();
    aim();
    beginStep(disturbance.capturePoint().y() > 0 ? Side::left : Side::right);
    loop.land({}, state.support);
  }

  double lean() const { return p.posture.torsoPitch + p.posture.torsoPitchPerSpeed * speed_.velocity().x(); }

  /// The rest of the step; its target keeps the place on the ground that it has for the perceived state.
  WalkAction planStep() const {
    const Side support = state.supportSide();
    const WalkState seen = perceivedState(state, tilt_, p);
    WalkAction action = planner_.step(seen, elapsed_, reference);
    const Pose2 target = model_.predict(seen, action).foot[index(support)].inverse() * action.stepTarget;
    const Pose2 foot = model_.predict(state, action).foot[index(support)];
    action.stepTarget = planner_.limitTarget(foot * target, foot, other(support));
    return action;
  }

  /// Advances the time, with all changes of support in it.
  void advance(const WalkRequest& request, double dt) {
    for (double left = dt; left > 1e-9;) {
      switch (mode_) {
        case Mode::stand:
          if (request.walk && planner_.canStand(state)) {
            mode_ = Mode::start;
            elapsed_ = 0;
            first_ = request.velocity.y() + 0.1 * request.turn > 0 ? Side::right : Side::left;
            break;
          }
          move(planner_.stand(state, left), left);
          left = 0;
          phase_ = 0;
          break;
        case Mode::start: {
          if (!request.walk) {
            mode_ = Mode::stand;
            break;
          }
          const WalkAction shift = planner_.start(state, p.startStop.duration - elapsed_, first_, reference);
          const double time = std::min(left, shift.duration);
          move(shift, time);
          left -= time;
          phase_ = elapsed_ / p.startStop.duration;
          if (elapsed_ >= p.startStop.duration - 1e-9) {
            loop.land({}, supportOf(first_));
            beginStep(first_);
          }
          break;
        }
        case Mode::walk:
          left -= walk(request, left);
          break;
      }
    }
  }

  double walk(const WalkRequest& request, double left) {
    const Side support = state.supportSide();
    const WalkAction action = contact_.adapted(planStep(), state, phase_, elapsed_, left, p);
    stepTarget_ = action.stepTarget;
    const WalkState end = model_.predict(state, action);
    if (action.duration <= left) {
      motion_ = motion_ * state.foot[index(support)] * end.foot[index(support)].inverse();
      loop.pass(action, action.duration);
      state = end;
      const bool settles = !request.walk && maySettle();
      loop.land(end.foot[index(support)].inverse() * end.foot[index(other(support))],
                settles ? Support::both : end.support);
      if (settles) {
        state.support = Support::both;
        mode_ = Mode::stand;
        elapsed_ = phase_ = 0;
      } else {
        beginStep(state.supportSide());
      }
      return action.duration;
    }
    landing_ = end.foot[index(support)].inverse() * action.stepTarget;
    move(action, left);
    stepTime_ = action.duration - left;
    phase_ = elapsed_ / (elapsed_ + action.duration - left);
    state.foot[index(other(support))] = state.foot[index(support)] * swung(landing_);
    return left;
  }

  /// The swing foot in the supporting foot's frame.
  Pose2 swung(const Pose2& target) const {
    Pose2 foot = swing_.between(liftOff_, target, phase_);
    if (kick_.now) foot.position.x() += KickStep{p.kick.back, p.kick.forward}.offset(phase_);
    return foot;
  }

  void beginStep(Side support) {
    mode_ = Mode::walk;
    kick_.beginStep(support);
    state.support = supportOf(support);
    elapsed_ = phase_ = 0;
    landing_ = liftOff_ = state.foot[index(support)].inverse() * state.foot[index(other(support))];
  }

  void move(const WalkAction& action, double time) {
    loop.pass(action, time);
    const WalkState moved = model_.move(state, action, time);
    const std::size_t fixed = index(state.supportSide());
    motion_ = motion_ * state.foot[fixed] * moved.foot[fixed].inverse();
    state = moved;
    elapsed_ += time;
  }

  /// Both feet stand side by side, slowly enough to stay there.
  bool maySettle() const {
    const Pose2 between = state.foot[1].inverse() * state.foot[0];
    return std::abs(between.x()) < 0.02 && std::abs(between.heading) < 0.1 &&
           std::abs(state.velocity.x()) < p.startStop.stopVelocity && planner_.canStand(state);
  }

  bool atRest() const {
    const Vec2 middle = (state.foot[0].position + state.foot[1].position) / 2 + Vec2(p.model.copForward, 0);
    return state.velocity.norm() < 0.02 && middle.norm() < 0.005;
  }

  void place(const JointArray& measured) {
    body_.update(state, mode_ == Mode::walk, swing_, phase_, lean(), tilt_, p, measured);
  }

  LinearInvertedPendulum model_;
  BodyCommand body_;
  StepPlanner planner_;
  SwingTrajectory swing_;

  Mode mode_ = Mode::stand;
  SpeedControl speed_;  ///< that the walk aims at now
  TurnToStop stop_;
  SpeedScale scale_;  ///< of the robot: stays when the walk is reset
  TorsoTilt tilt_;
  SupportSwitch contact_;
  FallGuard fall_;
  double elapsed_ = 0;  ///< of the step or of the shift before the first one [s]
  double phase_ = 0;
  Side first_ = Side::left;  ///< carries in the first step
  Pose2 liftOff_;            ///< the swing foot when the step began, in the supporting foot's frame
  KickRequest kick_;
  std::size_t stepsToTarget_ = 0;
  double stepTime_ = 0;         ///< left of the step in progress [s]
  Pose2 stepTarget_, landing_;  ///< of the step in progress
  Pose2 motion_;                ///< of the centre of mass frame in this cycle
  WalkOdometry odometry_;
  WalkOutput standing_;
};

WalkEngine::WalkEngine(const WalkGaits& gaits, const RobotModel& robot) {
  gaits.check();
  engine_ = std::make_unique<Implementation>(gaits, robot);
}
WalkEngine::~WalkEngine() = default;
WalkEngine::WalkEngine(WalkEngine&&) noexcept = default;
WalkEngine& WalkEngine::operator=(WalkEngine&&) noexcept = default;

WalkOutput WalkEngine::update(const WalkRequest& request, const WalkSensors& sensors) {
  return engine_->update(request, sensors);
}

void WalkEngine::setGaits(const WalkGaits& gaits) {
  gaits.check();
  engine_->gaits = gaits;
}

void WalkEngine::reset() { engine_->reset(); }
void WalkEngine::forget() { engine_->forget(); }
WalkOutput WalkEngine::stand() const { return engine_->stand(); }

const WalkState& WalkEngine::state() const { return engine_->state; }
WalkPlan WalkEngine::plan() const { return engine_->plan(); }
const WalkState& WalkEngine::observed() const { return engine_->loop.observed().state(); }
Vec2 WalkEngine::seenVelocity() const { return engine_->loop.observed().seenVelocity(); }
const WalkParameters& WalkEngine::gait() const { return engine_->p; }
Vec2 WalkEngine::imuDifference() const { return engine_->loop.observed().imuDifference(); }
double WalkEngine::recovering() const { return engine_->disturbance.share(); }
const Vec2& WalkEngine::capturePointError() const { return engine_->disturbance.capturePoint(); }
const ReferenceTrajectory& WalkEngine::reference() const { return engine_->reference; }
void WalkEngine::setModelParameters(const ModelParameters& parameters) { engine_->fit = parameters; }
const ModelParameters& WalkEngine::modelParameters() const { return engine_->fit; }
void WalkEngine::setPrediction(const ModelParameters& parameters) { engine_->prediction = parameters; }
const ModelParameters& WalkEngine::prediction() const { return engine_->prediction; }
const ObservedStep* WalkEngine::observedStep() { return engine_->recorder.take(); }

}  // namespace plumbline::walking
