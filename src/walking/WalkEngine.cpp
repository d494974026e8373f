#include "walking/WalkEngine.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "walking/Approach.h"
#include "walking/BodyPosture.h"
#include "walking/ClosedLoop.h"
#include "walking/KickStep.h"
#include "walking/LinearInvertedPendulum.h"
#include "walking/StepPlanner.h"
#include "walking/SwingTrajectory.h"

namespace plumbline::walking {
namespace {

enum class Mode { stand, start, walk };

double approach(double value, double goal, double maxChange) {
  return value + std::clamp(goal - value, -maxChange, maxChange);
}

StepLimits limitsOf(const WalkParameters& p, const LegKinematics& leg) {
  StepLimits limits;
  limits.forward = p.maxStepForward;
  limits.backward = p.maxStepBackward;
  limits.minOutward = p.minFeetDistance / 2;
  limits.maxOutward = p.maxStepOutward;
  limits.hipY = std::abs(leg.hip().y());
  // The ankle lies over the sole; a little is kept for the torso's own shift.
  const double drop = p.hipHeight - leg.ankleHeight();
  limits.reach = 0.95 * std::sqrt(std::max(0.0, leg.maxReach() * leg.maxReach() - drop * drop));
  limits.restX = p.copForward;
  limits.minDuration = p.minStepDuration;
  limits.maxDuration = p.maxStepDuration;
  return limits;
}

}  // namespace

class WalkEngine::Implementation {
public:
  Implementation(const WalkGaits& gaits_, const RobotModel& robot)
      : gaits(gaits_),
        p(gaits.base),
        loop(robot),
        model(p.pendulumHeight),
        posture(robot),
        planner(model, {}) {
    reset();
  }

  void reset() {
    velocity.setZero();
    turn = elapsed = phase = 0;
    useGait();
    mode = Mode::stand;
    kick = {};
    state = {};
    for (const Side side : {Side::left, Side::right})
      state.foot[index(side)] = Pose2(-p.copForward, outward(side) * p.feetDistance / 2);
    tilt.setZero();
    usualTilt.setZero();
    excess.setZero();
    rate.setZero();
    motion = {};
    loop.reset();
    recorder.reset();
    posture.reset();
    place({});
    torso = torsoOnGround();
    underway.clear();
    standing = output();
  }

  const WalkOutput& stand() const { return standing; }

  WalkOutput update(const WalkRequest& asked, const WalkSensors& sensors) {
    const WalkRequest request = withTarget(asked);
    follow(request, sensors.dt);
    feel(sensors);
    motion = {};
    observe(sensors);
    advance(request, sensors.dt);
    loop.endCycle();
    place(sensors.angles);
    return output(sensors.dt);
  }

  WalkOutput output(double dt = 0) {
    WalkOutput out;
    out.angles = angles;
    for (int j = lShoulderPitch; j < numJoints; ++j) out.set[static_cast<std::size_t>(j)] = true;
    const Pose2 newTorso = torsoOnGround();
    out.odometry = torso.inverse() * motion * newTorso;
    if (mode == Mode::walk) out.odometry.position.x() -= p.trimForward * dt;
    out.odometry.position = out.odometry.position.cwiseProduct(Vec2(p.odometryForward, p.odometrySideways));
    out.odometry.heading *= p.odometryTurn;
    // Told when it can be measured, not when it is commanded.
    underway.push_back(out.odometry);
    const auto delay = static_cast<std::size_t>(dt > 0 ? std::lround(p.odometryDelay / dt) : 0);
    out.odometry = {};
    for (; underway.size() > delay; underway.pop_front()) out.odometry = out.odometry * underway.front();
    torso = newTorso;
    out.support = state.support;
    out.phase = phase;
    out.stepTarget = stepTarget;
    out.stepTime = mode == Mode::walk ? stepTime : 0;
    out.kicking = kick.now;
    out.kicked = kick.done;
    out.stepsToTarget = stepsToTarget;
    out.standing = mode == Mode::stand && atRest();
    out.velocity = velocity;
    out.turn = turn;
    return out;
  }

  const WalkGaits gaits;
  WalkParameters p;  ///< at the present speed
  WalkState state;
  ReferenceTrajectory reference;
  ClosedLoop loop;
  StepRecorder recorder;
  ModelParameters fit;

private:
  /// A request for a target becomes one for a velocity or, there, for a stop or the kick.
  WalkRequest withTarget(WalkRequest request) {
    if (!request.kick) kick = {};
    stepsToTarget = 0;
    bool there = true;
    if (request.walk && request.target) {
      // The torso sways by some of this over its feet.
      constexpr ApproachTolerance arrived{.position = 0.025, .heading = 0.08};
      const ApproachPlan plan = planApproach(*request.target, velocity, turn, p, arrived);
      stepsToTarget = plan.steps.size();
      request.velocity = plan.velocity;
      request.turn = plan.turn;
      there = plan.steps.empty();
      if (there && (!request.kick || kick.done)) request.walk = false;
    }
    if (request.walk && request.kick && there && !kick.done && !kick.prepared) kick.foot = request.kick;
    return request;
  }

  /// Draws the velocity walked to the request, within the limits of speed and acceleration.
  void follow(const WalkRequest& request, double dt) {
    Vec2 goal = request.walk ? request.velocity : Vec2(Vec2::Zero());
    double goalTurn = request.walk ? request.turn : 0;
    const double forward = goal.x() < 0 ? p.maxBackward : p.maxForward;
    const double effort = std::hypot(goal.x() / forward, goal.y() / p.maxSideways, goalTurn / p.maxTurn);
    if (effort > 1) {
      goal /= effort;
      goalTurn /= effort;
    }
    goal.x() = outsideGap(goal.x(), forward);
    goal.y() = outsideGap(goal.y(), p.maxSideways);
    goalTurn = outsideGap(goalTurn, p.maxTurn);
    const double calm = std::clamp(1 - p.tiltBrake * excess.norm(), 0.0, 1.0);
    goal *= calm;
    goalTurn *= calm;
    if (mode == Mode::stand && !request.walk) {
      velocity.setZero();
      turn = 0;
      useGait();
      return;
    }
    const bool braking = std::abs(goal.x()) < std::abs(velocity.x()) || goal.x() * velocity.x() < 0;
    velocity.x() =
        approach(velocity.x(), goal.x(), (braking ? p.decelerationForward : p.accelerationForward) * dt);
    velocity.y() = approach(velocity.y(), goal.y(), p.accelerationSideways * dt);
    turn = approach(turn, goalTurn, p.accelerationTurn * dt);
    // The robot brakes before it turns: what forward speed leaves of the effort limits the rest.
    const double used = velocity.x() / (velocity.x() < 0 ? -p.maxBackward : p.maxForward);
    const double rest = std::max(0.0, 1 - used);
    const double side = std::hypot(velocity.y() / p.maxSideways, turn / p.maxTurn);
    if (side > rest) {
      velocity.y() *= rest / side;
      turn *= rest / side;
    }
    useGait();
    const double duration = kick.prepared ? p.kickDuration : p.stepDuration;
    reference = findReferenceTrajectory(model, {velocity + Vec2(p.trimForward, 0), turn, duration,
                                                p.feetDistance, Vec2(p.copForward, p.copOutward)});
  }

  /// A speed between two gaits is walked at the lower one's.
  double outsideGap(double speed, double full) const {
    constexpr double nearlyFull = 0.9;
    const double share = std::abs(speed) / full;
    return p.blendStart > 0 && share < nearlyFull ? std::copysign(std::min(share, p.blendStart) * full, speed)
                                                  : speed;
  }

  /// The parameters of the speed walked now.
  void useGait() {
    p = gaits.at(velocity, turn);
    model = LinearInvertedPendulum(Vec2(p.pendulumHeight, p.pendulumHeight + p.pendulumSideways),
                                   Vec2(p.copForward, p.copOutward), fit);
    StepLimits limits = limitsOf(p, posture.leg(Side::left));
    if (kick.prepared) limits.maxDuration = std::max(limits.maxDuration, 1.2 * p.kickDuration);
    planner.setLimits(limits);
    swing = {p.stepHeight, p.swingStart, p.swingEnd, p.swingSmoothness, p.swingSteepness};
  }

  /// The torso's deviation from its planned and usual attitude when the coming command takes effect.
  void feel(const WalkSensors& sensors) {
    rate = sensors.gyro.head<2>();
    const Vec2 deviation = sensors.torsoAngles - Vec2(0, lean());
    // Every walk has its own mean lean, which is no error to correct (compare section 4.2.8).
    if (p.tiltAverage > 0) usualTilt += (deviation - usualTilt) * std::min(1.0, sensors.dt / p.tiltAverage);
    const Vec2 tolerance = Vec2::Constant(p.tiltTolerance);
    excess = deviation - deviation.cwiseMax(-tolerance).cwiseMin(tolerance);
    tilt = deviation - usualTilt + p.delay * rate;
  }

  /// Draws the walk state slowly to the observed one (section 4.2.5).
  void observe(const WalkSensors& sensors) {
    const auto delay = static_cast<std::size_t>(std::lround(p.observationDelay / sensors.dt));
    const std::optional<WalkState> expected = loop.update(sensors, model, delay, p.imuAverage);
    if (!expected) return;
    recorder.add(
        loop.observed().state(),
        {Vec2(p.pendulumHeight, p.pendulumHeight + p.pendulumSideways), Vec2(p.copForward, p.copOutward)},
        sensors.dt);
    const auto pivot = [](const WalkState& s) {
      return s.support == Support::both ? Vec2((s.foot[0].position + s.foot[1].position) / 2)
                                        : s.supportFoot().position;
    };
    // No more in a cycle than a foot may slide.
    constexpr double most = 0.01;  // [m]
    Vec2 shift = p.observationPosition * (pivot(*expected) - pivot(state));
    if (shift.norm() > most) shift *= most / shift.norm();
    for (Pose2& foot : state.foot) foot.position += shift;
    motion = Pose2(Vec2(-shift));
    state.velocity += p.observationVelocity * (expected->velocity - state.velocity);
  }

  double lean() const { return p.torsoPitch + p.torsoPitchForward * velocity.x(); }

  /// The state as planning sees it: a share of the torso's tilt is motion of the pendulum about the foot.
  WalkState perceived() const {
    const double h = p.pendulumHeight;
    const Vec2 gain(p.stepForwardGain, p.stepSidewaysGain);
    const Vec2 shift = gain.cwiseProduct(Vec2(tilt.y(), -tilt.x())) * h;
    WalkState seen = state;
    for (Pose2& foot : seen.foot) foot.position -= shift;
    seen.velocity += gain.cwiseProduct(Vec2(rate.y(), -rate.x())) * h;
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
    const WalkAction action = planStep();
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
    if (kick.now) kick = {.foot = {}, .prepared = false, .now = false, .done = true};
    // The step before the kick already swings as far as the long step needs.
    if (kick.foot && kick.prepared && support == other(*kick.foot)) kick.now = true;
    if (kick.foot && support == *kick.foot) kick.prepared = true;
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

  /// The joint angles for the state.
  void place(const JointArray& measured) {
    angles[headYaw] = measured[headYaw];
    angles[headPitch] = measured[headPitch];
    const double stride = state.foot[0].x() - state.foot[1].x();
    for (const Side side : {Side::left, Side::right}) {
      const int arm = side == Side::left ? lShoulderPitch : rShoulderPitch;
      const double out = outward(side);
      double* joint = &angles[static_cast<std::size_t>(arm)];
      joint[0] = p.shoulderPitch + p.armSwing * out * stride;
      joint[1] = out * p.shoulderRoll;
      joint[2] = -out * p.elbowYaw;
      joint[3] = -out * p.elbowRoll;
    }
    std::array<FootPlacement, 2> feet;
    // The mass that leans out over the feet is brought back over them.
    const Vec2 lead = p.pendulumHeight * Vec2(p.comForwardGain * tilt.y(), -p.comSidewaysGain * tilt.x());
    for (std::size_t i = 0; i < 2; ++i) {
      feet[i].ground = state.foot[i];
      feet[i].ground.position += lead;
    }
    if (mode == Mode::walk) {
      FootPlacement& foot = feet[index(other(state.supportSide()))];
      foot.height = swing.height * swing.lift(phase);
      foot.pitch = p.swingPitch * swing.lift(phase) - p.swingLevel * tilt.y();
      foot.roll = -p.swingLevel * tilt.x();
    }
    posture.solve(feet, carriage(), angles);
    for (const Side side : {Side::left, Side::right}) {
      if (mode == Mode::walk && side != state.supportSide()) continue;
      double* leg = &angles[static_cast<std::size_t>(firstLegJoint(side))];
      leg[1] += p.hipRollGain * tilt.x() + p.hipRollRate * rate.x();
      leg[2] += p.hipPitchGain * tilt.y() + p.hipPitchRate * rate.y();
      leg[4] += p.anklePitchGain * tilt.y() + p.anklePitchRate * rate.y();
      leg[5] += p.ankleRollGain * tilt.x() + p.ankleRollRate * rate.x();
    }
  }

  /// The torso's attitude and height. It leans to the supporting leg in the middle of a step; then either the
  /// supporting hip or the middle of both, and with it the centre of mass, keeps its height (section 4.2.8).
  TorsoPlacement carriage() const {
    TorsoPlacement torso;
    torso.pitch = lean() + p.torsoMeasured * tilt.y();
    torso.roll = p.torsoMeasured * tilt.x();
    torso.hipHeight = p.hipHeight;
    if (mode == Mode::walk && p.torsoRoll != 0) {
      const double side = outward(state.supportSide());
      const double lean = p.torsoRoll * std::sin(pi * phase);
      torso.roll -= side * lean;
      // Leaning to a leg lowers its hip under the middle.
      torso.hipHeight += p.constantHipHeight * std::abs(posture.leg(Side::left).hip().y()) * std::sin(lean);
    }
    return torso;
  }

  Pose2 torsoOnGround() const { return Pose2(Vec2(posture.torso().translation().head<2>())); }

  LinearInvertedPendulum model;
  BodyPosture posture;
  StepPlanner planner;
  SwingTrajectory swing;

  Mode mode = Mode::stand;
  Vec2 velocity = Vec2::Zero();   ///< what the walk aims at now [m/s]
  double turn = 0;                ///< [rad/s]
  Vec2 tilt = Vec2::Zero();       ///< torso off its planned roll and pitch [rad]
  Vec2 excess = Vec2::Zero();     ///< what of it is more than tolerated [rad]
  Vec2 usualTilt = Vec2::Zero();  ///< running mean of the deviation [rad]
  Vec2 rate = Vec2::Zero();       ///< its turn rate about x and y [rad/s]
  double elapsed = 0;             ///< of the step or of the shift before the first one [s]
  double phase = 0;
  Side first = Side::left;  ///< carries in the first step
  Pose2 liftOff;            ///< the swing foot when the step began, in the supporting foot's frame
  struct Kick {
    std::optional<Side> foot;  ///< to kick with
    bool prepared = false;     ///< this step leads to it or is it
    bool now = false;
    bool done = false;
  } kick;
  std::size_t stepsToTarget = 0;
  double stepTime = 0;         ///< left of the step in progress [s]
  Pose2 stepTarget;            ///< of the step in progress
  Pose2 motion;                ///< of the centre of mass frame in this cycle
  Pose2 torso;                 ///< in the centre of mass frame, last cycle
  std::deque<Pose2> underway;  ///< odometry of commands that have not taken effect
  JointArray angles{};
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

WalkOutput WalkEngine::stand() const { return implementation->stand(); }

const WalkState& WalkEngine::state() const { return implementation->state; }
const WalkState& WalkEngine::observed() const { return implementation->loop.observed().state(); }
Vec2 WalkEngine::seenVelocity() const { return implementation->loop.observed().seenVelocity(); }
const WalkParameters& WalkEngine::gait() const { return implementation->p; }
Vec2 WalkEngine::imuDifference() const { return implementation->loop.observed().imuDifference(); }
const ReferenceTrajectory& WalkEngine::reference() const { return implementation->reference; }
void WalkEngine::setModelParameters(const ModelParameters& parameters) { implementation->fit = parameters; }
const ModelParameters& WalkEngine::modelParameters() const { return implementation->fit; }
const ObservedStep* WalkEngine::observedStep() { return implementation->recorder.take(); }

}  // namespace plumbline::walking
