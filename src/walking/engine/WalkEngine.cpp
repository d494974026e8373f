#include "walking/engine/WalkEngine.h"

#include <algorithm>
#include <cmath>

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

namespace plumbline::walking {
namespace {
enum class Mode { stand, start, walk };
}

class WalkEngine::Implementation {
public:
  Implementation(const WalkGaits& gaits_, const RobotModel& robot)
      : gaits(gaits_),
        p(gaits.base),
        loop(robot),
        model(p.model.pendulumHeight),
        body(robot),
        planner(model, {}) {
    reset();
  }

  void reset() {
    speed.reset();
    elapsed = phase = 0;
    useGait();
    mode = Mode::stand;
    kick = {};
    state = {};
    for (const Side side : {Side::left, Side::right})
      state.foot[index(side)] = Pose2(-p.model.copForward, outward(side) * p.posture.feetDistance / 2);
    tilt = {};
    contact.reset();
    fall.reset();
    disturbance.reset();
    motion = {};
    loop.reset();
    recorder.reset();
    body.reset();
    place({});
    odometry.reset(body.torsoOnGround());
    standing = output({});
  }

  void forget() { scale = {}; }

  const WalkOutput& stand() const { return standing; }
  WalkPlan plan() const { return {landing, body.torsoOnGround()}; }

  WalkOutput update(const WalkRequest& asked, const WalkSensors& sensors) {
    const WalkRequest request = withTarget(asked);
    follow(request, sensors.dt);
    tilt.update(sensors, lean(), p);
    contact.update(sensors);
    fall.update(sensors.torsoAngles - Vec2(0, lean()), sensors.gyro.head<2>(), sensors.dt,
                {.roll = p.fall.roll, .pitch = p.fall.pitch, .lead = p.fall.lead});
    motion = {};
    observe(sensors);
    advance(request, sensors.dt);
    loop.endCycle();
    place(sensors.angles);
    // At rest the velocity's noise is no motion.
    std::optional<Pose2> observed;
    if (sensors.feet && !(mode == Mode::stand && atRest())) observed = loop.observed().torsoMotion();
    return output(odometry.update(motion, body.torsoOnGround(), mode == Mode::walk, p, sensors.dt, observed));
  }

  WalkOutput output(const Pose2& moved) const {
    WalkOutput out;
    out.angles = body.angles();
    for (int j = lShoulderPitch; j < maxJoints; ++j) out.set[static_cast<std::size_t>(j)] = true;
    out.odometry = moved;
    out.support = state.support;
    out.phase = phase;
    out.stepTarget = stepTarget;
    out.stepTime = mode == Mode::walk ? stepTime : 0;
    out.kicking = kick.now;
    out.kicked = kick.done;
    out.stepsToTarget = stepsToTarget;
    out.standing = mode == Mode::stand && atRest();
    out.velocity = speed.velocity();
    out.turn = speed.turn();
    out.stiffness =
        WalkOutput::legStiffness(p.servo.hipStiffness, p.servo.kneeStiffness, p.servo.ankleStiffness);
    out.falling = fall.falling();
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
  /// A request for a target becomes one for a velocity or, there, for a stop or the kick.
  WalkRequest withTarget(WalkRequest request) {
    if (!request.kick) kick = {};
    stepsToTarget = 0;
    bool there = true;
    if (request.walk && request.target) {
      // The torso sways by some of this over its feet.
      constexpr ApproachTolerance arrived{.position = 0.025, .heading = 0.08};
      const ApproachPlan plan = planApproach(*request.target, speed.velocity(), speed.turn(), p, arrived);
      stepsToTarget = plan.steps.size();
      request.velocity = plan.velocity;
      request.turn = plan.turn;
      there = plan.steps.empty();
      if (there && (!request.kick || kick.done)) request.walk = false;
    }
    if (request.walk && request.kick && there && !kick.done && !kick.prepared) kick.foot = request.kick;
    return request;
  }

  Vec3 aimed() const { return {speed.velocity().x(), speed.velocity().y(), speed.turn()}; }

  /// What is planned so that the robot walks at its own speed.
  Vec3 planned() const {
    return scale.planned(aimed()) + Vec3(p.speed.trimForward + p.speed.brakeLead * speed.braking(), 0, 0);
  }

  /// Draws the speed walked to the request and finds the walk of it.
  void follow(const WalkRequest& request, double dt) {
    if (mode == Mode::stand && !request.walk) {
      speed.reset();
      useGait();
      return;
    }
    const Vec2 goal = request.walk ? request.velocity : Vec2(Vec2::Zero());
    if (mode == Mode::stand) speed.begin(goal, p);
    const double calm = std::clamp(1 - p.feedback.tiltBrake * tilt.excess.norm(), 0.0, 1.0);
    speed.update(goal, request.walk ? request.turn : 0, p, calm, dt);
    useGait();
    aim();
  }

  /// The walk of the speed aimed at.
  void aim() {
    const double duration = kick.prepared ? p.kick.duration : p.step.duration;
    const Vec3 plan = planned();
    reference = findReferenceTrajectory(model, {plan.head<2>(), plan.z(), duration, p.posture.feetDistance,
                                                p.model.pressure() - model.balance()});
  }

  /// The parameters of the speed walked now.
  void useGait() {
    p = gaits.at(speed.velocity(), speed.turn(), disturbance.share());
    model = LinearInvertedPendulum(p.model.heights(), p.model.pressure(), fit);
    StepLimits limits = stepLimits(p, body.leg(Side::left));
    if (kick.prepared) limits.maxDuration = std::max(limits.maxDuration, 1.2 * p.kick.duration);
    planner.setLimits(limits);
    swing = {p.step.height, p.step.swingStart, p.step.swingEnd, p.step.swingSmoothness,
             p.step.swingSteepness};
  }

  /// Draws the walk state slowly to the observed one (section 4.2.5).
  void observe(const WalkSensors& sensors) {
    const auto delay = static_cast<std::size_t>(std::lround(p.observation.delay / sensors.dt));
    const LinearInvertedPendulum observing(p.model.heights(), p.model.pressure(), prediction);
    const std::optional<WalkState> expected = loop.update(sensors, observing, delay, p.observation.imuWindow);
    if (!expected) return;
    recorder.add(loop.observed().state(), {p.model.heights(), p.model.pressure()}, sensors.dt);
    learnSpeed(sensors);
    disturbance.update(state, *expected, phase, p.model.pendulumHeight, p, sensors.dt);
    // No more in a cycle than a foot may slide, or than the body can have tilted.
    const double most = 0.01 + 0.03 * disturbance.share();  // [m]
    const Vec2 shift = shortened(p.observation.positionGain * disturbance.foot().cwiseProduct(
                                                                  Vec2(1, p.observation.positionGainLateral)),
                                 most);
    for (Pose2& foot : state.foot) foot.position += shift;
    motion = Pose2(Vec2(-shift));
    state.velocity += p.observation.velocityGain *
                      disturbance.velocity().cwiseProduct(Vec2(1, p.observation.velocityGainLateral));
    if (mode == Mode::stand && !planner.canHold(*expected, p.recovery.captureMargin)) captureStep();
  }

  /// Where the feet's forces tell how the robot moves.
  void learnSpeed(const WalkSensors& sensors) {
    if (!sensors.feet || mode != Mode::walk || kick.prepared || disturbance.share() > 0) return;
    const Pose2& moved = loop.observed().torsoMotion();
    scale.update(aimed(), Vec3(moved.x(), moved.y(), moved.heading) / sensors.dt, p.speed.scaleWindow,
                 sensors.dt);
  }

  /// Standing cannot hold what was observed: the foot on the side of the capture point carries, the other one
  /// steps.
  void captureStep() {
    speed.reset();
    disturbance.begin();
    useGait();
    aim();
    beginStep(disturbance.capturePoint().y() > 0 ? Side::left : Side::right);
    loop.land({}, state.support);
  }

  double lean() const { return p.posture.torsoPitch + p.posture.torsoPitchPerSpeed * speed.velocity().x(); }

  /// The rest of the step in progress; its target keeps the place on the ground that it has for the perceived
  /// state.
  WalkAction planStep() const {
    const Side support = state.supportSide();
    const WalkState seen = perceivedState(state, tilt, p);
    WalkAction action = planner.step(seen, elapsed, reference);
    const Pose2 target = model.predict(seen, action).foot[index(support)].inverse() * action.stepTarget;
    const Pose2 foot = model.predict(state, action).foot[index(support)];
    action.stepTarget = planner.limitTarget(foot * target, foot, other(support));
    return action;
  }

  /// Lets the time pass, through as many changes of support as fall into it.
  void advance(const WalkRequest& request, double dt) {
    for (double left = dt; left > 1e-9;) {
      switch (mode) {
        case Mode::stand:
          if (request.walk && planner.canStand(state)) {
            mode = Mode::start;
            elapsed = 0;
            first = request.velocity.y() + 0.1 * request.turn > 0 ? Side::right : Side::left;
            break;
          }
          move(planner.stand(state, left), left);
          left = 0;
          phase = 0;
          break;
        case Mode::start: {
          if (!request.walk) {
            mode = Mode::stand;
            break;
          }
          const WalkAction shift = planner.start(state, p.startStop.duration - elapsed, first, reference);
          const double time = std::min(left, shift.duration);
          move(shift, time);
          left -= time;
          phase = elapsed / p.startStop.duration;
          if (elapsed >= p.startStop.duration - 1e-9) {
            loop.land({}, supportOf(first));
            beginStep(first);
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
    const WalkAction action = contact.adapted(planStep(), state, phase, elapsed, left, p);
    stepTarget = action.stepTarget;
    const WalkState end = model.predict(state, action);
    if (action.duration <= left) {
      motion = motion * state.foot[index(support)] * end.foot[index(support)].inverse();
      loop.pass(action, action.duration);
      state = end;
      const bool settles = !request.walk && maySettle();
      loop.land(end.foot[index(support)].inverse() * end.foot[index(other(support))],
                settles ? Support::both : end.support);
      if (settles) {
        state.support = Support::both;
        mode = Mode::stand;
        elapsed = phase = 0;
      } else {
        beginStep(state.supportSide());
      }
      return action.duration;
    }
    landing = end.foot[index(support)].inverse() * action.stepTarget;
    move(action, left);
    stepTime = action.duration - left;
    phase = elapsed / (elapsed + action.duration - left);
    state.foot[index(other(support))] = state.foot[index(support)] * swung(landing);
    return left;
  }

  /// The swing foot in the supporting foot's frame.
  Pose2 swung(const Pose2& target) const {
    Pose2 foot = swing.between(liftOff, target, phase);
    if (kick.now) foot.position.x() += KickStep{p.kick.back, p.kick.forward}.offset(phase);
    return foot;
  }

  void beginStep(Side support) {
    mode = Mode::walk;
    kick.beginStep(support);
    state.support = supportOf(support);
    elapsed = phase = 0;
    landing = liftOff = state.foot[index(support)].inverse() * state.foot[index(other(support))];
  }

  void move(const WalkAction& action, double time) {
    loop.pass(action, time);
    const WalkState moved = model.move(state, action, time);
    const std::size_t fixed = index(state.supportSide());
    motion = motion * state.foot[fixed] * moved.foot[fixed].inverse();
    state = moved;
    elapsed += time;
  }

  /// Both feet stand side by side, slowly enough to stay there.
  bool maySettle() const {
    const Pose2 between = state.foot[1].inverse() * state.foot[0];
    return std::abs(between.x()) < 0.02 && std::abs(between.heading) < 0.1 &&
           std::abs(state.velocity.x()) < p.startStop.stopVelocity && planner.canStand(state);
  }

  bool atRest() const {
    const Vec2 middle = (state.foot[0].position + state.foot[1].position) / 2 + Vec2(p.model.copForward, 0);
    return state.velocity.norm() < 0.02 && middle.norm() < 0.005;
  }

  void place(const JointArray& measured) {
    body.update(state, mode == Mode::walk, swing, phase, lean(), tilt, p, measured);
  }

  LinearInvertedPendulum model;
  BodyCommand body;
  StepPlanner planner;
  SwingTrajectory swing;

  Mode mode = Mode::stand;
  SpeedControl speed;  ///< that the walk aims at now
  SpeedScale scale;    ///< of the robot: stays when the walk is reset
  TorsoTilt tilt;
  SupportSwitch contact;
  FallGuard fall;
  double elapsed = 0;  ///< of the step or of the shift before the first one [s]
  double phase = 0;
  Side first = Side::left;  ///< carries in the first step
  Pose2 liftOff;            ///< the swing foot when the step began, in the supporting foot's frame
  KickRequest kick;
  std::size_t stepsToTarget = 0;
  double stepTime = 0;        ///< left of the step in progress [s]
  Pose2 stepTarget, landing;  ///< of the step in progress
  Pose2 motion;               ///< of the centre of mass frame in this cycle
  WalkOdometry odometry;
  WalkOutput standing;
};

WalkEngine::WalkEngine(const WalkGaits& gaits, const RobotModel& robot) {
  gaits.check();
  implementation = std::make_unique<Implementation>(gaits, robot);
}
WalkEngine::~WalkEngine() = default;
WalkEngine::WalkEngine(WalkEngine&&) noexcept = default;
WalkEngine& WalkEngine::operator=(WalkEngine&&) noexcept = default;

WalkOutput WalkEngine::update(const WalkRequest& request, const WalkSensors& sensors) {
  return implementation->update(request, sensors);
}

void WalkEngine::setGaits(const WalkGaits& gaits) {
  gaits.check();
  implementation->gaits = gaits;
}

void WalkEngine::reset() { implementation->reset(); }
void WalkEngine::forget() { implementation->forget(); }

WalkOutput WalkEngine::stand() const { return implementation->stand(); }

const WalkState& WalkEngine::state() const { return implementation->state; }
WalkPlan WalkEngine::plan() const { return implementation->plan(); }
const WalkState& WalkEngine::observed() const { return implementation->loop.observed().state(); }
Vec2 WalkEngine::seenVelocity() const { return implementation->loop.observed().seenVelocity(); }
const WalkParameters& WalkEngine::gait() const { return implementation->p; }
Vec2 WalkEngine::imuDifference() const { return implementation->loop.observed().imuDifference(); }
double WalkEngine::recovering() const { return implementation->disturbance.share(); }
const Vec2& WalkEngine::capturePointError() const { return implementation->disturbance.capturePoint(); }
const ReferenceTrajectory& WalkEngine::reference() const { return implementation->reference; }
void WalkEngine::setModelParameters(const ModelParameters& parameters) { implementation->fit = parameters; }
const ModelParameters& WalkEngine::modelParameters() const { return implementation->fit; }
void WalkEngine::setPrediction(const ModelParameters& parameters) { implementation->prediction = parameters; }
const ModelParameters& WalkEngine::prediction() const { return implementation->prediction; }
const ObservedStep* WalkEngine::observedStep() { return implementation->recorder.take(); }

}  // namespace plumbline::walking
