#include "simulation/servo/ServoWorld.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "math/Index.h"

namespace plumbline::simulation {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double ballRadius = 0.03;  ///< of links that are no feet [m]
constexpr double stopErp = 0.2;      ///< share of a joint's way beyond its stop undone in a step
constexpr double leastRotor = 1e-9;  ///< a row needs some softness [kg m^2]
constexpr double creep = 1e-5;       ///< of contacts that stick [m/(s N)]
constexpr int mostRounds = 12;       ///< of solving with more and more limits reached

int stepsIn(double hz, double step) {
  if (!(step > 0) || !(hz > 0))
    throw std::invalid_argument("servo world: the step and the control rate must be above zero");
  return std::max(1, static_cast<int>(std::ceil(1 / hz / step - 1e-9)));
}

}  // namespace

ServoWorld::ServoWorld(const Mechanism& mechanism, const ServoWorldConfig& config_)
    : mechanism_(mechanism),
      config(config_),
      stepsPerCycle(stepsIn(mechanism.controlHz, config_.stepSeconds)),
      h(1 / mechanism.controlHz / stepsPerCycle) {
  std::vector<bool> isFoot(mechanism_.links.size(), false);
  for (std::size_t f = 0; f < mechanism_.feet.size(); ++f) {
    const Mechanism::Foot& foot = mechanism_.feet[f];
    isFoot[at(foot.link)] = true;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      Point point;
      point.link = foot.link;
      point.foot = static_cast<int>(f);
      point.local = foot.soleCentre + foot.soleSize.cwiseProduct(sign);
      points.push_back(point);
    }
  }
  for (std::size_t i = 0; i < mechanism_.links.size(); ++i)
    if (!isFoot[i]) {
      Point point;
      point.link = static_cast<int>(i);
      point.local = mechanism_.links[i].com;
      point.radius = ballRadius;
      points.push_back(point);
    }
  restart(Pose3::Identity(), std::vector<double>(at(mechanism_.numJoints()), 0));
}

void ServoWorld::restart(const Pose3& T_world_base, const std::vector<double>& q) {
  if (static_cast<int>(q.size()) != mechanism_.numJoints())
    throw std::invalid_argument("servo world: " + std::to_string(q.size()) + " positions for " +
                                std::to_string(mechanism_.numJoints()) + " joints");
  // A new multi-body is the one way to leave no trace of the past in it.
  body = std::make_unique<ServoBody>(mechanism_, config.fixedBase);
  std::vector<double> start = q;
  for (std::size_t i = 0; i < q.size(); ++i)
    if (const Mechanism::Joint& joint = mechanism_.joints[i]; joint.driver >= 0)
      start[i] = joint.driven(start[at(joint.driver)]);
  body->place(T_world_base, start);
  joints.assign(q.size(), {});
  for (std::size_t i = 0; i < q.size(); ++i) joints[i].target = start[i];
  for (Point& point : points) point.force.setZero();
  pushSteps = cycles = 0;
  torqueSum.assign(q.size(), 0);
  readings_ = {};
  senseImu();
  sense();
  readings_.acc = rotationOfRpy(mechanism_.imu.rpy).transpose() *
                  (link(mechanism_.imu.link).pose.linear().transpose() * Vec3(-mechanism_.gravity));
}

void ServoWorld::restart(const std::vector<double>& q, double heading) {
  restart(rotationZ(heading), q);
  double lowest = infinity;
  for (const Point& point : points)
    lowest = std::min(lowest, (link(point.link).pose * point.local).z() - point.radius);
  restart(translation(0, 0, -lowest) * rotationZ(heading), q);
}

void ServoWorld::command(const std::vector<double>& targets) {
  if (targets.size() != joints.size())
    throw std::invalid_argument("servo world: " + std::to_string(targets.size()) + " targets for " +
                                std::to_string(joints.size()) + " joints");
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (!std::isfinite(targets[i]))
      throw std::invalid_argument("servo world: target of " + mechanism_.joints[i].name + " is not finite");
  for (std::size_t i = 0; i < joints.size(); ++i) joints[i].target = targets[i];
}

void ServoWorld::setStiffness(double stiffness) {
  for (int i = 0; i < mechanism_.numJoints(); ++i) setStiffness(i, stiffness);
}

void ServoWorld::setStiffness(int joint, double stiffness) {
  joints.at(at(joint)).stiffness = std::clamp(stiffness, 0.0, 1.0);
}

void ServoWorld::push(const Vec3& force, double seconds, int link) {
  mechanism_.links.at(at(link));
  pushForce = force;
  pushLink = link;
  pushSteps = std::lround(seconds / h);
}

void ServoWorld::step() {
  const Vec3 before = imuVelocity;
  std::fill(torqueSum.begin(), torqueSum.end(), 0.0);
  for (int i = 0; i < stepsPerCycle; ++i) substep();
  ++cycles;
  senseImu();
  const double seconds = stepsPerCycle * h;
  const Mat3 toSensor =
      (link(mechanism_.imu.link).pose.linear() * rotationOfRpy(mechanism_.imu.rpy)).transpose();
  readings_.acc = toSensor * ((imuVelocity - before) / seconds - mechanism_.gravity);
  sense();
}

void ServoWorld::substep() {
  if (pushSteps > 0) {
    --pushSteps;
    body->addForce(pushLink, pushForce, link(pushLink).pose * mechanism_.links[at(pushLink)].com);
  }
  rates.clear();
  for (int i = 0; i < mechanism_.numJoints(); ++i) rates.push_back(body->velocity(i));
  body->begin(mechanism_.gravity, h);
  rows.clear();
  for (int i = 0; i < mechanism_.numJoints(); ++i) addServoRow(i);
  for (int i = 0; i < mechanism_.numJoints(); ++i) addStopRow(i);
  for (std::size_t i = 0; i < points.size(); ++i) addContactRows(static_cast<int>(i));
  solve();
  takeForces();
  body->finish(impulses, h);
}

void ServoWorld::addRow(const Row& row, int local) {
  body->rows().place(local, static_cast<Eigen::Index>(rows.size()));
  rows.push_back(row);
}

void ServoWorld::addServoRow(int joint) {
  const Mechanism::Joint& spec = mechanism_.joints[at(joint)];
  if (spec.driver >= 0) {
    const double gap = body->position(joint) - spec.driven(body->position(spec.driver));
    addRow({Row::Kind::drive, joint, -stopErp / h * gap, 1e-9, -infinity, infinity},
           body->addDriveRow(joint, spec.driver, spec.driverRatio));
    return;
  }
  linearLaw(joint);
  addRow({Row::Kind::servo, joint, 0, 0, -infinity, infinity}, body->addJointRow(joint));
}

void ServoWorld::addStopRow(int joint) {
  const Mechanism::Joint& spec = mechanism_.joints[at(joint)];
  if (spec.driver >= 0) return;
  const double q = body->position(joint);
  const double beyond = q < spec.lower ? q - spec.lower : q > spec.upper ? q - spec.upper : 0;
  if (beyond == 0) return;
  addRow({Row::Kind::stop, joint, -stopErp / h * beyond, 1e-9, beyond < 0 ? 0 : -infinity,
          beyond < 0 ? infinity : 0},
         body->addJointRow(joint));
}

void ServoWorld::addContactRows(int index) {
  Point& point = points[at(index)];
  point.force.setZero();
  point.world = link(point.link).pose * point.local - Vec3(0, 0, point.radius);
  if (config.fixedBase || point.world.z() > 0) return;
  const double k = config.groundStiffness, d = config.groundDamping;
  // A spring and a damper with their force at the end of the step.
  const double soft = 1 / (h * h * k + h * d);
  addRow({Row::Kind::push, index, soft * h * k * -point.world.z(), soft, 0, infinity},
         body->addPointRow(point.link, point.world, Vec3::UnitZ()));
  for (const Vec3& across : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())})
    addRow({Row::Kind::friction, index, 0, creep / h, -infinity, infinity},
           body->addPointRow(point.link, point.world, across));
}

/// Torque of the servo below its limits.
void ServoWorld::linearLaw(int joint) {
  const Servo& servo = mechanism_.joints[at(joint)].servo;
  JointState& state = joints[at(joint)];
  const double s = state.stiffness, error = state.target - body->position(joint);
  // The error at the end of the step is smaller by what the joint moves until then.
  state.law0 = s * servo.kp * error;
  state.law1 = s * (servo.kd + h * servo.kp);
  state.saturated = false;
}

/// Torque of a servo that gives all it has in the direction of sign; a DC motor still brakes itself.
void ServoWorld::saturatedLaw(int joint, double sign) {
  const Servo& servo = mechanism_.joints[at(joint)].servo;
  JointState& state = joints[at(joint)];
  state.saturated = true;
  state.law1 = 0;
  state.law0 = sign * limit(joint, sign);
  if (servo.model == Servo::Model::dcMotor) {
    state.law0 = sign * state.stiffness * servo.kt * servo.vin * servo.maxPwm / servo.R;
    state.law1 = state.stiffness * servo.kt * servo.kt / servo.R;
  }
}

/// Most torque in the direction of sign: it fades over the last tenth below the top speed.
double ServoWorld::limit(int joint, double sign) const {
  const Mechanism::Joint& spec = mechanism_.joints[at(joint)];
  const double speed = sign * rates[at(joint)];
  const double fade =
      spec.maxSpeed > 0 ? std::clamp((spec.maxSpeed - speed) / (0.1 * spec.maxSpeed), 0.0, 1.0) : 1.0;
  return joints[at(joint)].stiffness * spec.maxTorque * fade;
}

/// impulse = h (law0 - law1 v) + rotor (v before - v), as a row v + impulse / (h law1 + rotor) = wanted.
void ServoWorld::setLaw(std::size_t row) {
  const int joint = rows[row].index;
  const JointState& state = joints[at(joint)];
  const double rotor = std::max(mechanism_.joints[at(joint)].servo.armature, leastRotor);
  const double soft = 1 / (h * state.law1 + rotor);
  const auto i = static_cast<Eigen::Index>(row);
  system.a(i, i) += soft - rows[row].compliance;
  system.b[i] += soft * (h * state.law0 + rotor * rates[at(joint)]) - rows[row].wanted;
  rows[row].compliance = soft;
  rows[row].wanted = soft * (h * state.law0 + rotor * rates[at(joint)]);
}

void ServoWorld::solve() {
  system.reset(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto i = static_cast<Eigen::Index>(r);
    system.a(i, i) = rows[r].compliance;
    system.b[i] = rows[r].wanted;
    system.lower[i] = rows[r].lower;
    system.upper[i] = rows[r].upper;
  }
  body->rows().addTo(system);
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r].kind == Row::Kind::servo) setLaw(r);
  for (int round = 0; round < mostRounds; ++round) {
    system.solve();
    const bool servos = limitServos(), contacts = limitFriction();
    if (!servos && !contacts) break;
  }
  impulses = system.solution();
}

/// Gives servos that would need more than they have their limit; whether any did.
bool ServoWorld::limitServos() {
  bool changed = false;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].kind != Row::Kind::servo) continue;
    JointState& state = joints[at(rows[r].index)];
    if (state.saturated) continue;
    const double velocity =
        rows[r].wanted - rows[r].compliance * system.solution()[static_cast<Eigen::Index>(r)];
    const double torque = state.law0 - state.law1 * velocity, sign = torque < 0 ? -1 : 1;
    const Servo& servo = mechanism_.joints[at(rows[r].index)].servo;
    bool beyond = std::abs(torque) > limit(rows[r].index, sign);
    if (servo.model == Servo::Model::dcMotor) {
      const double error = state.target - body->position(rows[r].index) - h * velocity;
      beyond = std::abs(servo.kpFirmware * servo.errorGain * error) > servo.maxPwm;
    }
    if (!beyond) continue;
    saturatedLaw(rows[r].index, sign);
    setLaw(r);
    changed = true;
  }
  return changed;
}

/// Keeps friction within its cone; whether that changed anything.
bool ServoWorld::limitFriction() {
  bool changed = false;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].kind != Row::Kind::push) continue;
    const auto i = static_cast<Eigen::Index>(r);
    const double most = config.groundFriction * std::max(0.0, system.solution()[i]);
    const Vec2 friction = system.solution().segment<2>(i + 1);
    const double size = friction.norm();
    if (size <= most * (1 + 1e-6) + 1e-12) continue;
    for (int k = 0; k < 2; ++k) {
      // Along each axis what the cone has in the direction in which the point would be held.
      const double bound = size > 0 ? most * std::abs(friction[k]) / size : 0;
      system.lower[i + 1 + k] = -bound;
      system.upper[i + 1 + k] = bound;
    }
    changed = true;
  }
  return changed;
}

void ServoWorld::takeForces() {
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto i = static_cast<Eigen::Index>(r);
    const Row& row = rows[r];
    if (row.kind == Row::Kind::push)
      points[at(row.index)].force = Vec3(impulses[i + 1], impulses[i + 2], impulses[i]) / h;
    if (row.kind == Row::Kind::servo) {
      JointState& state = joints[at(row.index)];
      state.torque = state.law0 - state.law1 * (row.wanted - row.compliance * impulses[i]);
      torqueSum[at(row.index)] += state.torque;
    }
  }
}

void ServoWorld::senseImu() {
  const BodyState& carrier = link(mechanism_.imu.link);
  imuVelocity = carrier.linearVelocity +
                carrier.angularVelocity.cross(carrier.pose.linear() * mechanism_.imu.accelerometer);
  readings_.gyro =
      (carrier.pose.linear() * rotationOfRpy(mechanism_.imu.rpy)).transpose() * carrier.angularVelocity;
}

void ServoWorld::sense() {
  readings_.time = static_cast<double>(cycles) * stepsPerCycle * h;
  readings_.position.resize(joints.size());
  readings_.velocity.resize(joints.size());
  readings_.torque.resize(joints.size());
  for (int i = 0; i < mechanism_.numJoints(); ++i) {
    readings_.position[at(i)] = body->position(i);
    readings_.velocity[at(i)] = body->velocity(i);
    readings_.torque[at(i)] = torqueSum[at(i)] / stepsPerCycle;
  }
  readings_.footForce.clear();
  for (std::size_t f = 0; f < mechanism_.feet.size(); ++f)
    readings_.footForce.push_back(footForces(static_cast<int>(f)));
}

/// The sole's force along its normal, shared by the sensors as a plane over them with the same centre of
/// pressure would; no sensor pulls.
std::vector<double> ServoWorld::footForces(int index) const {
  const Mechanism::Foot& foot = mechanism_.feet[at(index)];
  const Mat3 toFoot = link(foot.link).pose.linear().transpose();
  double whole = 0;
  Vec2 centre = Vec2::Zero();
  for (const Point& point : points)
    if (point.foot == index && !point.force.isZero(0)) {
      const double normal = (toFoot * point.force).z();
      whole += normal;
      centre += normal * point.local.head<2>();
    }
  std::vector<double> shares(foot.sensors.size(), 0);
  if (!(whole > 0) || shares.empty()) return shares;
  centre /= whole;
  Mat3 moments = 1e-9 * Mat3::Identity();
  for (const Mechanism::ForceSensor& sensor : foot.sensors) {
    const Vec3 m(1, sensor.position.x(), sensor.position.y());
    moments += m * m.transpose();
  }
  const Vec3 plane = moments.inverse() * Vec3(1, centre.x(), centre.y());
  double sum = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Vec3& p = foot.sensors[i].position;
    shares[i] = std::max(0.0, plane.dot(Vec3(1, p.x(), p.y())));
    sum += shares[i];
  }
  for (double& share : shares) share *= sum > 0 ? whole / sum : 0;
  return shares;
}

}  // namespace plumbline::simulation
