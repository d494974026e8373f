#include "gap/replay/Stepper.h"

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

}  // namespace

Stepper::Stepper(const Plant& plant, const Trial& trial, const std::vector<int>& joints,
                 const std::vector<std::uint8_t>* lostCycles)
    : plant_(plant), trial_(trial), tree_(plant.mechanism, joints, trial.freeBase), supply_(plant.joints) {
  n_ = tree_.size();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto joint = index(joints[i]);
    const JointPlant& p = plant_.joints[joint];
    Drive drive{.path = CommandPath(p, trial_, joint, lostCycles)};
    drive.joint = joints[i];
    drive.link = drive.motor = tree_.baseSize() + static_cast<int>(i);
    drive.armature = p.servo.armature;
    if (p.geared()) {
      drive.motor = n_++;
      Gear gear;
      gear.drive = static_cast<int>(i);
      gear.play = p.backlash;
      gear.stiffness = p.compliance > 0 ? 1 / p.compliance : p.toothStiffness;
      gear.damping = (p.compliance > 0 ? 0.1 : p.toothDamping) *
                     std::sqrt(gear.stiffness * std::max(p.servo.armature, 1e-4));
      gears_.push_back(gear);
    }
    drive.sensed = p.linkEncoder ? drive.link : drive.motor;
    if (p.rubs()) frictions_.push_back({static_cast<int>(i), drive.motor, {}, 0});
    drives_.push_back(drive);
  }
  weight_ = gears_.empty() && !trial_.freeBase ? 0.5 : 0.55;
  q_.setZero(n_);
  v_.setZero(n_);
  for (Drive& drive : drives_) {
    const auto joint = index(drive.joint);
    double start = firstFinite(trial_.targets(joint), 0);
    const Signal* measured = trial_.freeBase ? nullptr : positionOf(trial_, drive.joint);
    if (measured) start = firstFinite(measured->values, start);
    q_[drive.link] = q_[drive.motor] = start + plant_.joints[joint].offset;
  }
  qm_ = u_ = rhs_ = force_ = predicted_ = Eigen::VectorXd::Zero(n_);
  acceleration_.setZero(tree_.size());
  A_.setZero(n_, n_);
  if (trial_.freeBase) {
    contacts_ = std::make_shared<Contacts>(plant_, tree_);
    placeOnGround();
  }
  hold();
}

void Stepper::lose(const std::vector<std::uint8_t>* lostCycles) {
  for (Drive& drive : drives_) drive.path.lose(lostCycles);
}

double Stepper::limitShare(const Drive& drive) const {
  const double loss = plant_.joints[index(drive.joint)].deratingPerJoule;
  return loss > 0 ? std::max(0.0, 1 - loss * drive.heat) : 1;
}

DryFriction Stepper::frictionBound(const Drive& drive) const {
  return dryFriction(plant_.joints[index(drive.joint)], v_[drive.motor], drive.load);
}

void Stepper::assemble(double h) {
  const double a = weight_ * h;
  const int rigid = tree_.size();
  A_.setZero();
  A_.topLeftCorner(rigid, rigid) = tree_.mass();
  force_.setZero();
  force_.head(rigid) = -tree_.bias();
  for (const ExternalForce& external : plant_.forces) {
    const auto& link = plant_.mechanism.links[index(external.link)];
    // Links of chains that are not replayed here carry it themselves.
    if (external.link != 0 && !std::ranges::any_of(drives_, [&](const Drive& d) {
          return plant_.mechanism.joints[index(d.joint)].child == external.link;
        })) {
      continue;
    }
    Eigen::VectorXd tau = Eigen::VectorXd::Zero(rigid);
    tree_.addForce(external.link, tree_.origin(external.link) + tree_.rotation(external.link) * link.com,
                   external.force, tau);
    force_.head(rigid) += tau;
  }
  for (Drive& drive : drives_) A_(drive.motor, drive.motor) += drive.armature;
  rhs_.noalias() = A_ * v_;
  for (Drive& drive : drives_) {
    const JointPlant& p = plant_.joints[index(drive.joint)];
    const ServoLine& line = drive.line;
    force_[drive.motor] += line.torque - line.stiffness * q_[drive.sensed];
    if (drive.sensed == drive.motor) {
      A_(drive.motor, drive.motor) += a * a * line.stiffness + a * line.damping;
    } else {
      // The servo feels the link across the gear: explicit, for a matrix that stays symmetric.
      force_[drive.motor] -= (line.stiffness * a + line.damping) * v_[drive.sensed];
    }
    A_(drive.motor, drive.motor) += a * p.viscous;
    force_[drive.link] += p.biasForce;
    for (const JointTorque& torque : p.torques) force_[drive.link] += torque(q_[drive.link], v_[drive.link]);
  }
  for (const Gear& gear : gears_) {
    if (gear.play > 0 && gear.side == 0) continue;
    const Drive& drive = drives_[index(gear.drive)];
    const double stretch = q_[drive.motor] - q_[drive.link] - gear.side * gear.play / 2;
    const double implicit = a * gear.damping + a * a * gear.stiffness;
    force_[drive.motor] -= gear.stiffness * stretch;
    force_[drive.link] += gear.stiffness * stretch;
    A_(drive.motor, drive.motor) += implicit;
    A_(drive.link, drive.link) += implicit;
    A_(drive.motor, drive.link) -= implicit;
    A_(drive.link, drive.motor) -= implicit;
  }
  rhs_ += a * force_;
}

void Stepper::solve(double h) {
  factor_.compute(A_);
  const auto rows = static_cast<Eigen::Index>(frictions_.size());
  solved_.setZero(n_, rows + 1);
  for (Eigen::Index i = 0; i < rows; ++i) solved_(frictions_[static_cast<std::size_t>(i)].coordinate, i) = h;
  solved_.col(rows) = rhs_;
  factor_.solveInPlace(solved_);
  u_ = solved_.col(rows);
  Eigen::VectorXd& fresh = predicted_;  // velocity at the end of the step
  fresh = v_ + (u_ - v_) / weight_;
  if (!frictions_.empty() || contacts_) {
    unbound_ = fresh;
    columns_ = solved_.leftCols(rows);
    pushed_.setZero(n_);
    double hold = 0;
    for (const Friction& friction : frictions_)
      hold += (friction.bound.forward + friction.bound.backward) / 2;
    if (contacts_) contacts_->prepare(factor_, h);
    const int rounds = rows && contacts_ ? mostRounds : 1;
    for (int round = 0; round < rounds; ++round) {
      fresh = unbound_ + pushed_;
      for (Eigen::Index i = 0; i < rows; ++i)
        fresh += columns_.col(i) * frictions_[static_cast<std::size_t>(i)].force;
      double changed = 0;  // what contacts have undone of what frictions hold
      for (int sweep = 0; sweep < (rows > 1 ? frictionSweeps : 1); ++sweep) {
        double moved = 0;
        for (Eigen::Index i = 0; i < rows; ++i) {
          Friction& friction = frictions_[static_cast<std::size_t>(i)];
          const double w = columns_(friction.coordinate, i);
          const double wanted = std::clamp(friction.force - fresh[friction.coordinate] / w,
                                           -friction.bound.forward, friction.bound.backward);
          const double delta = wanted - friction.force;
          fresh += columns_.col(i) * delta;
          friction.force = wanted;
          moved += std::abs(delta);
        }
        if (sweep == 0) changed = moved;
        if (moved < 1e-9) break;
      }
      // Else what sticks would creep.
      if (!contacts_ || (round > 0 && changed <= agreed * hold)) break;
      const Eigen::VectorXd before = fresh - pushed_;
      fresh = before;
      contacts_->solve(h, fresh);
      pushed_ = fresh - before;
    }
    u_ = v_ + weight_ * (fresh - v_);
  }
}

bool Stepper::regimesHold(double h) {
  const double a = weight_ * h;
  bool same = true;
  for (Drive& drive : drives_) {
    const ServoLine line = servoLine(
        plant_.joints[index(drive.joint)], drive.command, drive.path.stiffness(), drive.path.voltage(),
        q_[drive.sensed] + a * u_[drive.sensed], u_[drive.sensed], limitShare(drive),
        supply_.left(plant_.joints[index(drive.joint)]), drive.path.speedSent(), drive.path.torqueSent());
    if (line.regime != drive.line.regime) same = false;
    drive.line = line;
  }
  for (Gear& gear : gears_) {
    if (gear.play <= 0) continue;
    const Drive& drive = drives_[index(gear.drive)];
    const double stretch = q_[drive.motor] - q_[drive.link] + a * (u_[drive.motor] - u_[drive.link]);
    const int side = stretch > gear.play / 2 ? 1 : stretch < -gear.play / 2 ? -1 : 0;
    if (side != gear.side) same = false;
    gear.side = side;
  }
  return same;
}

void Stepper::step(double from, double to) {
  const double h = to - from, a = weight_ * h;
  for (Drive& drive : drives_) {
    drive.command = drive.path.over(from, to);
    drive.shownBefore = drive.shown;
    drive.rateBefore = drive.rate;
  }
  u_ = v_;
  qm_ = q_ + a * v_;
  Mat3 R = T_world_base_.linear();
  Vec3 middle = T_world_base_.translation();
  if (trial_.freeBase) {
    const Vec3 turn = a * v_.segment<3>(3);
    const double angle = turn.norm();
    if (angle > 1e-12) R = Eigen::AngleAxisd(angle, turn / angle) * R;
    middle += a * v_.head<3>();
  }
  tree_.update(R, qm_.data() + tree_.baseSize(), v_.data());
  if (contacts_) contacts_->update(tree_, middle);
  for (Friction& friction : frictions_) friction.bound = frictionBound(drives_[index(friction.drive)]);
  regimesHold(h);
  for (int round = 0; round < maxRegimes; ++round) {
    assemble(h);
    solve(h);
    const std::vector<Gear> gearsUsed = gears_;
    if (regimesHold(h)) break;
    if (round + 1 == maxRegimes) gears_ = gearsUsed;
  }
  advance(h);
}

void Stepper::advance(double h) {
  acceleration_ = (predicted_ - v_).head(tree_.size()) / h;
  for (Drive& drive : drives_) {
    drive.torque = drive.line.at(q_[drive.sensed] + weight_ * h * u_[drive.sensed], u_[drive.sensed]);
    drive.heat +=
        h * std::abs(drive.torque) *
        (plant_.joints[index(drive.joint)].heatIsWork ? std::abs(u_[drive.motor]) : std::abs(drive.torque));
  }
  double torques = 0;
  for (Drive& drive : drives_) {
    const double gear = drive.torque - drive.armature * (predicted_[drive.motor] - v_[drive.motor]) / h;
    drive.load = {drive.torque, gear, gear};
    torques += std::abs(drive.torque);
  }
  for (const Friction& friction : frictions_) drives_[index(friction.drive)].load.link += friction.force;
  supply_.take(torques, h);
  q_ += h * u_;
  v_ = predicted_;
  if (trial_.freeBase) {
    T_world_base_.translation() += h * u_.head<3>();
    const Vec3 turn = h * u_.segment<3>(3);
    const double angle = turn.norm();
    if (angle > 1e-12) {
      Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle, turn / angle) * T_world_base_.linear());
      T_world_base_.linear() = rotation.normalized().toRotationMatrix();
    }
    q_.head<6>().setZero();
    if (T_world_base_.linear()(2, 2) < 0.5) hasFallen_ = true;
  }
  for (Drive& drive : drives_) {
    drive.shown = measuredAngle(plant_.joints[index(drive.joint)], q_[drive.sensed]);
    drive.rate = v_[drive.sensed];
  }
}

double Stepper::torqueConstant(int node) const {
  const double kt = plant_.joints[index(drives_[index(node)].joint)].servo.kt;
  return kt > 0 ? kt : unmeasured;
}

double Stepper::supplyCurrent(int node, double current, double rate) const {
  const Drive& drive = drives_[index(node)];
  const JointPlant& plant = plant_.joints[index(drive.joint)];
  return current * dutyThatDraws(plant, current, rate, drive.path.voltage());
}

double Stepper::torqueAt(int node, double shown, double rate) const {
  const Drive& drive = drives_[index(node)];
  const JointPlant& plant = plant_.joints[index(drive.joint)];
  // The encoder's error changes slowly enough to be taken at the reading.
  const double angle = 2 * shown - measuredAngle(plant, shown);
  return servoLine(plant, drive.path.atEnd(), drive.path.stiffness(), drive.path.voltage(), angle, rate,
                   limitShare(drive), supply_.left(plant), drive.path.speedSent(), drive.path.torqueSent())
      .at(angle, rate);
}

double Stepper::duty(int node, double shown) const {
  const Drive& drive = drives_[index(node)];
  return dutyOf(plant_.joints[index(drive.joint)], drive.path.atEnd(), shown);
}

void Stepper::beginBody() {
  bodyTime_.clear();
  gyro_.clear();
  specificForce_.clear();
}

void Stepper::readBody(std::size_t cycle, double t, const std::vector<std::size_t>& signals,
                       std::vector<std::vector<double>>& values) {
  tree_.update(T_world_base_.linear(), q_.data() + tree_.baseSize(), v_.data());
  const Mechanism::Imu& imu = plant_.mechanism.imu;
  const bool carried = imu.link == 0 || trial_.freeBase;
  const Mat3 R_world_sensor = (carried ? tree_.rotation(imu.link) : Mat3(Mat3::Identity())) *
                              rotationOfRpy(imu.rpy) * plant_.imu.R_true_sensor;
  bodyTime_.push_back(t);
  if (trial_.freeBase) {
    gyro_.emplace_back(R_world_sensor.transpose() * tree_.angularVelocity(imu.link));
    const Vec3 point = tree_.origin(imu.link) + tree_.rotation(imu.link) * imu.accelerometer;
    specificForce_.emplace_back(R_world_sensor.transpose() *
                                tree_.specificForceAt(imu.link, point, acceleration_.data()));
  } else {
    gyro_.emplace_back(Vec3::Zero());
    specificForce_.emplace_back(-(R_world_sensor.transpose() * plant_.mechanism.gravity));
  }
  gyro_.back() += plant_.imu.gyroBias;
  if (!trial_.freeBase) return;

  const std::array<double, 7> pose = poseValues(T_world_base_);
  std::vector<std::vector<double>> feet(plant_.mechanism.feet.size());
  for (const std::size_t s : signals) {
    const Signal& signal = trial_.signals[s];
    if (signal.kind == SignalKind::truth) values[s][cycle] = pose[index(signal.axis)];
    if (signal.kind != SignalKind::force) continue;
    auto& shares = feet[index(signal.place)];
    if (shares.empty()) {
      const Contacts::FootForce total = contacts_->footForce(signal.place, tree_);
      shares = plateForces(plant_.mechanism.feet[index(signal.place)], total.normal, total.centre);
      for (double& share : shares) share *= plant_.footGain[index(signal.place)];
    }
    values[s][cycle] = shares[index(signal.axis)];
  }
}

void Stepper::endBody(const std::vector<std::size_t>& signals,
                      std::vector<std::vector<double>>& values) const {
  for (const std::size_t s : signals) {
    const Signal& signal = trial_.signals[s];
    if (signal.kind != SignalKind::gyro && signal.kind != SignalKind::accelerometer) continue;
    const std::vector<Vec3>& series = signal.kind == SignalKind::gyro ? gyro_ : specificForce_;
    std::size_t at = 0;
    for (std::size_t k = 0; k < bodyTime_.size(); ++k) {
      const double when = bodyTime_[k] - plant_.imu.delay;
      while (at + 1 < bodyTime_.size() && bodyTime_[at + 1] <= when) ++at;
      double value = series[at][signal.axis];
      if (at + 1 < bodyTime_.size() && when > bodyTime_[at]) {
        const double share = (when - bodyTime_[at]) / (bodyTime_[at + 1] - bodyTime_[at]);
        value += share * (series[at + 1][signal.axis] - value);
      }
      values[s][k] = value;
    }
  }
}

}  // namespace plumbline::gap
