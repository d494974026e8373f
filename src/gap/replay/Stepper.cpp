#include "gap/replay/Stepper.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/replay/SolePlate.h"
#include "gap/replay/TruePose.h"

namespace plumbline::gap {

namespace {

constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();
constexpr int maxRegimes = 5, frictionSweeps = 30;
constexpr int mostRounds = 30;    // of frictions and contacts in turn
constexpr double agreed = 0.002;  // of what frictions can hold: change in the last

double firstFinite(const std::vector<double>& values, double otherwise) {
  for (const double value : values)
    if (std::isfinite(value)) return value;
  return otherwise;
}

const std::vector<double>* positionsOf(const Trial& trial, int joint) {
  for (const Signal& signal : trial.signals)
    if (signal.kind == SignalKind::position && signal.joint == joint) return &signal.values;
  return nullptr;
}

}  // namespace

Stepper::Stepper(const Plant& plant_, const Trial& trial_, const std::vector<int>& joints,
                 const std::vector<std::uint8_t>* lostCycles)
    : plant(plant_), trial(trial_), tree(plant_.mechanism, joints, trial_.freeBase), supply(plant_.joints) {
  n = tree.size();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto joint = index(joints[i]);
    const JointPlant& p = plant.joints[joint];
    Drive drive{.path = CommandPath(p, trial, joint, lostCycles)};
    drive.joint = joints[i];
    drive.link = drive.motor = tree.baseSize() + static_cast<int>(i);
    drive.armature = p.servo.armature;
    if (p.geared()) {
      drive.motor = n++;
      Gear gear;
      gear.drive = static_cast<int>(i);
      gear.play = p.backlash;
      gear.stiffness = p.compliance > 0 ? 1 / p.compliance : p.toothStiffness;
      gear.damping = (p.compliance > 0 ? 0.1 : p.toothDamping) *
                     std::sqrt(gear.stiffness * std::max(p.servo.armature, 1e-4));
      gears.push_back(gear);
    }
    drive.sensed = p.linkEncoder ? drive.link : drive.motor;
    if (p.rubs()) frictions.push_back({static_cast<int>(i), drive.motor, {}, 0});
    drives.push_back(drive);
  }
  weight = gears.empty() && !trial.freeBase ? 0.5 : 0.55;
  q.setZero(n);
  v.setZero(n);
  for (Drive& drive : drives) {
    const auto joint = index(drive.joint);
    double start = firstFinite(trial.targets(joint), 0);
    const std::vector<double>* measured = trial.freeBase ? nullptr : positionsOf(trial, drive.joint);
    if (measured) start = firstFinite(*measured, start);
    q[drive.link] = q[drive.motor] = start + plant.joints[joint].offset;
  }
  qm = u = rhs = force = predicted = Eigen::VectorXd::Zero(n);
  acceleration.setZero(tree.size());
  A.setZero(n, n);
  if (trial.freeBase) {
    contacts = std::make_shared<Contacts>(plant, tree);
    placeOnGround();
  }
  hold();
}

void Stepper::lose(const std::vector<std::uint8_t>* lostCycles) {
  for (Drive& drive : drives) drive.path.lose(lostCycles);
}

double Stepper::limitShare(const Drive& drive) const {
  const double loss = plant.joints[index(drive.joint)].deratingPerJoule;
  return loss > 0 ? std::max(0.0, 1 - loss * drive.heat) : 1;
}

DryFriction Stepper::frictionBound(const Drive& drive) const {
  return dryFriction(plant.joints[index(drive.joint)], v[drive.motor], drive.load);
}

void Stepper::assemble(double h) {
  const double a = weight * h;
  const int rigid = tree.size();
  A.setZero();
  A.topLeftCorner(rigid, rigid) = tree.mass();
  force.setZero();
  force.head(rigid) = -tree.bias();
  for (const ExternalForce& external : plant.forces) {
    const auto& link = plant.mechanism.links[index(external.link)];
    // Links of chains that are not replayed here carry it themselves.
    if (external.link != 0 && !std::ranges::any_of(drives, [&](const Drive& d) {
          return plant.mechanism.joints[index(d.joint)].child == external.link;
        })) {
      continue;
    }
    Eigen::VectorXd tau = Eigen::VectorXd::Zero(rigid);
    tree.addForce(external.link, tree.origin(external.link) + tree.rotation(external.link) * link.com,
                  external.force, tau);
    force.head(rigid) += tau;
  }
  for (Drive& drive : drives) A(drive.motor, drive.motor) += drive.armature;
  rhs.noalias() = A * v;
  for (Drive& drive : drives) {
    const JointPlant& p = plant.joints[index(drive.joint)];
    const ServoLine& line = drive.line;
    force[drive.motor] += line.torque - line.stiffness * q[drive.sensed];
    if (drive.sensed == drive.motor) {
      A(drive.motor, drive.motor) += a * a * line.stiffness + a * line.damping;
    } else {
      // The servo feels the link across the gear: explicit, for a matrix that stays symmetric.
      force[drive.motor] -= (line.stiffness * a + line.damping) * v[drive.sensed];
    }
    A(drive.motor, drive.motor) += a * p.viscous;
    force[drive.link] += p.biasForce;
    for (const JointTorque& torque : p.torques) force[drive.link] += torque(q[drive.link], v[drive.link]);
  }
  for (const Gear& gear : gears) {
    if (gear.play > 0 && gear.side == 0) continue;
    const Drive& drive = drives[index(gear.drive)];
    const double stretch = q[drive.motor] - q[drive.link] - gear.side * gear.play / 2;
    const double implicit = a * gear.damping + a * a * gear.stiffness;
    force[drive.motor] -= gear.stiffness * stretch;
    force[drive.link] += gear.stiffness * stretch;
    A(drive.motor, drive.motor) += implicit;
    A(drive.link, drive.link) += implicit;
    A(drive.motor, drive.link) -= implicit;
    A(drive.link, drive.motor) -= implicit;
  }
  rhs += a * force;
}

void Stepper::solve(double h) {
  factor.compute(A);
  u = factor.solve(rhs);
  Eigen::VectorXd fresh = v + (u - v) / weight;  // velocity at the end of the step
  if (!frictions.empty() || contacts) {
    const Eigen::VectorXd unbound = fresh;
    const auto rows = static_cast<Eigen::Index>(frictions.size());
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(n, rows);
    for (Eigen::Index i = 0; i < rows; ++i) columns(frictions[static_cast<std::size_t>(i)].coordinate, i) = h;
    factor.solveInPlace(columns);
    Eigen::VectorXd pushed = Eigen::VectorXd::Zero(n);  // what contacts add
    double hold = 0;
    for (const Friction& friction : frictions) hold += (friction.bound.forward + friction.bound.backward) / 2;
    if (contacts) contacts->prepare(factor, h);
    const int rounds = rows && contacts ? mostRounds : 1;
    for (int round = 0; round < rounds; ++round) {
      fresh = unbound + pushed;
      for (Eigen::Index i = 0; i < rows; ++i)
        fresh += columns.col(i) * frictions[static_cast<std::size_t>(i)].force;
      double changed = 0;  // what contacts have undone of what frictions hold
      for (int sweep = 0; sweep < (rows > 1 ? frictionSweeps : 1); ++sweep) {
        double moved = 0;
        for (Eigen::Index i = 0; i < rows; ++i) {
          Friction& friction = frictions[static_cast<std::size_t>(i)];
          const double w = columns(friction.coordinate, i);
          const double wanted = std::clamp(friction.force - fresh[friction.coordinate] / w,
                                           -friction.bound.forward, friction.bound.backward);
          const double delta = wanted - friction.force;
          fresh += columns.col(i) * delta;
          friction.force = wanted;
          moved += std::abs(delta);
        }
        if (sweep == 0) changed = moved;
        if (moved < 1e-9) break;
      }
      // Else what sticks would creep.
      if (!contacts || (round > 0 && changed <= agreed * hold)) break;
      const Eigen::VectorXd before = fresh - pushed;
      fresh = before;
      contacts->solve(h, fresh);
      pushed = fresh - before;
    }
    u = v + weight * (fresh - v);
  }
  predicted = fresh;
}

bool Stepper::regimesHold(double h) {
  const double a = weight * h;
  bool same = true;
  for (Drive& drive : drives) {
    const ServoLine line = servoLine(
        plant.joints[index(drive.joint)], drive.command, drive.path.stiffness(), drive.path.voltage(),
        q[drive.sensed] + a * u[drive.sensed], u[drive.sensed], limitShare(drive),
        supply.left(plant.joints[index(drive.joint)]), drive.path.speedSent(), drive.path.torqueSent());
    if (line.regime != drive.line.regime) same = false;
    drive.line = line;
  }
  for (Gear& gear : gears) {
    if (gear.play <= 0) continue;
    const Drive& drive = drives[index(gear.drive)];
    const double stretch = q[drive.motor] - q[drive.link] + a * (u[drive.motor] - u[drive.link]);
    const int side = stretch > gear.play / 2 ? 1 : stretch < -gear.play / 2 ? -1 : 0;
    if (side != gear.side) same = false;
    gear.side = side;
  }
  return same;
}

void Stepper::step(double from, double to) {
  const double h = to - from, a = weight * h;
  for (Drive& drive : drives) {
    drive.command = drive.path.over(from, to);
    drive.shownBefore = drive.shown;
    drive.rateBefore = drive.rate;
  }
  u = v;
  qm = q + a * v;
  Mat3 R = T_world_base.linear();
  Vec3 middle = T_world_base.translation();
  if (trial.freeBase) {
    const Vec3 turn = a * v.segment<3>(3);
    const double angle = turn.norm();
    if (angle > 1e-12) R = Eigen::AngleAxisd(angle, turn / angle) * R;
    middle += a * v.head<3>();
  }
  tree.update(R, qm.data() + tree.baseSize(), v.data());
  if (contacts) contacts->update(tree, middle);
  for (Friction& friction : frictions) friction.bound = frictionBound(drives[index(friction.drive)]);
  regimesHold(h);
  for (int round = 0; round < maxRegimes; ++round) {
    assemble(h);
    solve(h);
    const std::vector<Gear> gearsUsed = gears;
    if (regimesHold(h)) break;
    if (round + 1 == maxRegimes) gears = gearsUsed;
  }
  advance(h);
}

void Stepper::advance(double h) {
  acceleration = (predicted - v).head(tree.size()) / h;
  for (Drive& drive : drives) {
    drive.torque = drive.line.at(q[drive.sensed] + weight * h * u[drive.sensed], u[drive.sensed]);
    drive.heat +=
        h * std::abs(drive.torque) *
        (plant.joints[index(drive.joint)].heatIsWork ? std::abs(u[drive.motor]) : std::abs(drive.torque));
  }
  double torques = 0;
  for (Drive& drive : drives) {
    const double gear = drive.torque - drive.armature * (predicted[drive.motor] - v[drive.motor]) / h;
    drive.load = {drive.torque, gear, gear};
    torques += std::abs(drive.torque);
  }
  for (const Friction& friction : frictions) drives[index(friction.drive)].load.link += friction.force;
  supply.take(torques, h);
  q += h * u;
  v = predicted;
  if (trial.freeBase) {
    T_world_base.translation() += h * u.head<3>();
    const Vec3 turn = h * u.segment<3>(3);
    const double angle = turn.norm();
    if (angle > 1e-12) {
      Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle, turn / angle) * T_world_base.linear());
      T_world_base.linear() = rotation.normalized().toRotationMatrix();
    }
    q.head<6>().setZero();
    if (T_world_base.linear()(2, 2) < 0.5) hasFallen = true;
  }
  for (Drive& drive : drives) {
    drive.shown = measuredAngle(plant.joints[index(drive.joint)], q[drive.sensed]);
    drive.rate = v[drive.sensed];
  }
}

double Stepper::current(int node) const {
  const Drive& drive = drives[index(node)];
  const double kt = plant.joints[index(drive.joint)].servo.kt;
  return kt > 0 ? drive.torque / kt : unmeasured;
}

double Stepper::duty(int node) const {
  const Drive& drive = drives[index(node)];
  const Servo& servo = plant.joints[index(drive.joint)].servo;
  if (servo.model != Servo::Model::dcMotor) return unmeasured;
  const double duty = servo.kpFirmware * servo.errorGain * (drive.command - drive.shown);
  return std::clamp(duty, -servo.maxPwm, servo.maxPwm);
}

void Stepper::beginBody() {
  bodyTime.clear();
  gyro.clear();
  specificForce.clear();
}

void Stepper::readBody(std::size_t cycle, double t, const std::vector<std::size_t>& signals,
                       std::vector<std::vector<double>>& values) {
  tree.update(T_world_base.linear(), q.data() + tree.baseSize(), v.data());
  const Mechanism::Imu& imu = plant.mechanism.imu;
  const bool carried = imu.link == 0 || trial.freeBase;
  const Mat3 R_world_sensor = (carried ? tree.rotation(imu.link) : Mat3(Mat3::Identity())) *
                              rotationOfRpy(imu.rpy) * plant.imu.R_true_sensor;
  bodyTime.push_back(t);
  if (trial.freeBase) {
    gyro.emplace_back(R_world_sensor.transpose() * tree.angularVelocity(imu.link));
    const Vec3 point = tree.origin(imu.link) + tree.rotation(imu.link) * imu.accelerometer;
    specificForce.emplace_back(R_world_sensor.transpose() *
                               tree.specificForceAt(imu.link, point, acceleration.data()));
  } else {
    gyro.emplace_back(Vec3::Zero());
    specificForce.emplace_back(-(R_world_sensor.transpose() * plant.mechanism.gravity));
  }
  gyro.back() += plant.imu.gyroBias;
  if (!trial.freeBase) return;

  const std::array<double, 7> pose = poseValues(T_world_base);
  std::vector<std::vector<double>> feet(plant.mechanism.feet.size());
  for (const std::size_t s : signals) {
    const Signal& signal = trial.signals[s];
    if (signal.kind == SignalKind::truth) values[s][cycle] = pose[index(signal.axis)];
    if (signal.kind != SignalKind::force) continue;
    auto& shares = feet[index(signal.place)];
    if (shares.empty()) {
      const Contacts::FootForce total = contacts->footForce(signal.place, tree);
      shares = plateForces(plant.mechanism.feet[index(signal.place)], total.normal, total.centre);
      for (double& share : shares) share *= plant.footGain[index(signal.place)];
    }
    values[s][cycle] = shares[index(signal.axis)];
  }
}

void Stepper::endBody(const std::vector<std::size_t>& signals,
                      std::vector<std::vector<double>>& values) const {
  for (const std::size_t s : signals) {
    const Signal& signal = trial.signals[s];
    if (signal.kind != SignalKind::gyro && signal.kind != SignalKind::accelerometer) continue;
    const std::vector<Vec3>& series = signal.kind == SignalKind::gyro ? gyro : specificForce;
    std::size_t at = 0;
    for (std::size_t k = 0; k < bodyTime.size(); ++k) {
      const double when = bodyTime[k] - plant.imu.delay;
      while (at + 1 < bodyTime.size() && bodyTime[at + 1] <= when) ++at;
      double value = series[at][signal.axis];
      if (at + 1 < bodyTime.size() && when > bodyTime[at]) {
        const double share = (when - bodyTime[at]) / (bodyTime[at + 1] - bodyTime[at]);
        value += share * (series[at + 1][signal.axis] - value);
      }
      values[s][k] = value;
    }
  }
}

}  // namespace plumbline::gap
