#include "walking/WalkEngine.h"

#include <algorithm>
#include <cmath>

#include "walking/Approach.h"
#include "walking/BodyCommand.h"
#include "walking/ClosedLoop.h"
#include "walking/Disturbance.h"
#include "walking/FallGuard.h"
#include "walking/KickRequest.h"
#include "walking/KickStep.h"
#include "walking/LinearInvertedPendulum.h"
#include "walking/SpeedControl.h"
#include "walking/SpeedScale.h"
#include "walking/StepPlanner.h"
#include "walking/SupportSwitch.h"
#include "walking/SwingTrajectory.h"
#include "walking/TorsoTilt.h"
#include "walking/WalkOdometry.h"

namespace plumbline::walking {
namespace {

enum class Mode { stand, start, walk };

}  // namespace

class WalkEngine::Implementation {
public:
  Implementation(const WalkGaits& gaits_, const RobotModel& robot)
      : gaits(gaits_), p(gaits.base), loop(robot), model(p.pendulumHeight), body(robot), planner(model, {}) {
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
      state.foot[index(side)] = Pose2(-p.copForward, outward(side) * p.feetDistance / 2);
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

  WalkOutput update(const WalkRequest& asked, const WalkSensors& sensors) {
    const WalkRequest request = withTarget(asked);
    follow(request, sensors.dt);
    tilt.update(sensors, lean(), p);
    contact.update(sensors);
    fall.update(sensors.torsoAngles - Vec2(0, lean()), sensors.gyro.head<2>(), sensors.dt,
                {.roll = p.fallRoll, .pitch = p.fallPitch, .lead = p.fallLead});
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
    for (int j = lShoulderPitch; j < numJoints; ++j) out.set[static_cast<std::size_t>(j)] = true;
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
    out.hardness = WalkOutput::legHardness(p.hipHardness, p.kneeHardness, p.ankleHardness);
    out.falling = fall.falling();
    if (out.falling) out.hardness.fill(0);
    return out;
  }

  const WalkGaits gaits;
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
    return scale.planned(aimed()) + Vec3(p.trimForward + p.brakeLead * speed.braking(), 0, 0);
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
    const double calm = std::clamp(1 - p.tiltBrake * tilt.excess.norm(), 0.0, 1.0);
    speed.update(goal, request.walk ? request.turn : 0, p, calm, dt);
    useGait();
    aim();
  }

  /// The walk of the speed aimed at.
  void aim() {
    const double duration = kick.prepared ? p.kickDuration : p.stepDuration;
    const Vec3 plan = planned();
    reference = findReferenceTrajectory(
        model, {plan.head<2>(), plan.z(), duration, p.feetDistance, pressure() - model.balance()});
  }

  /// The parameters of the speed walked now.
  void useGait() {
    p = gaits.at(speed.velocity(), speed.turn(), disturbance.share());
    model = LinearInvertedPendulum(heights(), pressure(), fit);
    StepLimits limits = stepLimits(p, body.leg(Side::left));
    if (kick.prepared) limits.maxDuration = std::max(limits.maxDuration, 1.2 * p.kickDuration);
    planner.setLimits(limits);
    swing = {p.stepHeight, p.swingStart, p.swingEnd, p.swingSmoothness, p.swingSteepness};
  }

  /// Draws the walk state slowly to the observed one (section 4.2.5).
  void observe(const WalkSensors& sensors) {
    const auto delay = static_cast<std::size_t>(std::lround(p.observationDelay / sensors.dt));
    const LinearInvertedPendulum observing(heights(), pressure(), prediction);
    const std::optional<WalkState> expected = loop.update(sensors, observing, delay, p.imuAverage);
    if (!expected) return;
    recorder.add(loop.observed().state(), {heights(), pressure()}, sensors.dt);
    learnSpeed(sensors);
    disturbance.update(state, *expected, phase, p.pendulumHeight, p, sensors.dt);
    // No more in a cycle than a foot may slide, or than the body can have tilted.
    const double most = 0.01 + 0.03 * disturbance.share();  // [m]
    const Vec2 shift = shortened(
        p.observationPosition * disturbance.foot().cwiseProduct(Vec2(1, p.observationBeside)), most);
    for (Pose2& foot : state.foot) foot.position += shift;
    motion = Pose2(Vec2(-shift));
    state.velocity +=
        p.observationVelocity * disturbance.velocity().cwiseProduct(Vec2(1, p.observationSideways));
    if (mode == Mode::stand && !planner.canHold(*expected, p.captureMargin)) captureStep();
  }

  /// Where the feet's forces tell how the robot moves.
  void learnSpeed(const WalkSensors& sensors) {
    if (!sensors.feet || mode != Mode::walk || kick.prepared || disturbance.share() > 0) return;
    const Pose2& moved = loop.observed().torsoMotion();
    scale.update(aimed(), Vec3(moved.x(), moved.y(), moved.heading) / sensors.dt, p.speedAverage, sensors.dt);
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

  /// Of the pendulum forward and sideways [m].
  Vec2 heights() const { return {p.pendulumHeight, p.pendulumHeight + p.pendulumSideways}; }
  /// The centre of pressure of a carrying foot, to the outside [m].
  Vec2 pressure() const { return {p.copForward, p.copOutward}; }

  double lean() const { return p.torsoPitch + p.torsoPitchForward * speed.velocity().x(); }

  /// The state as planning sees it: a share of the torso's tilt is motion of the pendulum about the foot.
  WalkState perceived() const {
    const double h = p.pendulumHeight;
    const Vec2 gain(p.stepForwardGain, p.stepSidewaysGain);
    const Vec2 shift = gain.cwiseProduct(Vec2(tilt.angle.y(), -tilt.angle.x())) * h;
    WalkState seen = state;
    for (Pose2& foot : seen.foot) foot.position -= shift;
    seen.velocity += gain.cwiseProduct(Vec2(tilt.rate.y(), -tilt.rate.x())) * h;
    return seen;
  }

  /// The rest of the step in progress; its target keeps the place on the ground that it has for the perceived
  /// state.
  WalkAction planStep() const {
    const Side support = state.supportSide();
    const WalkState seen = perceived();
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
          const WalkAction shift = planner.start(state, p.startDuration - elapsed, first, reference);
          const double time = std::min(left, shift.duration);
          move(shift, time);
          left -= time;
          phase = elapsed / p.startDuration;
          if (elapsed >= p.startDuration - 1e-9) {
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
    const Pose2 target = end.foot[index(support)].inverse() * action.stepTarget;
    move(action, left);
    stepTime = action.duration - left;
    phase = elapsed / (elapsed + action.duration - left);
    state.foot[index(other(support))] = state.foot[index(support)] * swung(target);
    return left;
  }

  /// The swing foot in the supporting foot's frame.
  Pose2 swung(const Pose2& target) const {
    Pose2 foot = swing.between(liftOff, target, phase);
    if (kick.now) foot.position.x() += KickStep{p.kickBack, p.kickForward}.offset(phase);
    return foot;
  }

  void beginStep(Side support) {
    mode = Mode::walk;
    kick.beginStep(support);
    state.support = supportOf(support);
    elapsed = phase = 0;
    liftOff = state.foot[index(support)].inverse() * state.foot[index(other(support))];
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
           std::abs(state.velocity.x()) < p.stopVelocity && planner.canStand(state);
  }

  bool atRest() const {
    const Vec2 middle = (state.foot[0].position + state.foot[1].position) / 2 + Vec2(p.copForward, 0);
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
  double stepTime = 0;  ///< left of the step in progress [s]
  Pose2 stepTarget;     ///< of the step in progress
  Pose2 motion;         ///< of the centre of mass frame in this cycle
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

void WalkEngine::reset() { implementation->reset(); }
void WalkEngine::forget() { implementation->forget(); }

WalkOutput WalkEngine::stand() const { return implementation->stand(); }

const WalkState& WalkEngine::state() const { return implementation->state; }
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
