#include "gap/replay/Stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/replay/DoublePair.h"

namespace plumbline::gap {

namespace {

constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();
constexpr int maxRegimes = 5, frictionSweeps = 30;
constexpr int mostRounds = 30;       // of frictions and contacts in turn
constexpr double maxChange = 0.002;  // in the last round, as a share of what frictions can hold

double firstFinite(const std::vector<double>& values, double fallback) {
  for (const double value : values)
    if (std::isfinite(value)) return value;
  return fallback;
}

}  // namespace

Stepper::Stepper(const Plant& plant, const Trial& trial, const std::vector<int>& joints,
                 const std::vector<std::uint8_t>* lostCycles)
    : plant_(plant), trial_(trial), tree_(plant.mechanism, joints, trial.freeBase), supply_(plant.joints) {
  n_ = tree_.size();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto joint = index(joints[i]);
    const JointPlant& p = plant_.joints[joint];
    Drive drive{.path = CommandPath(p, trial_, joint, lostCycles, plant.dropout), .plant = &p};
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
    if (p.hasFriction()) frictions_.push_back({static_cast<int>(i), drive.motor, {}, 0});
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
  takeForces();
  hold();
}

void Stepper::lose(const std::vector<std::uint8_t>* lostCycles) {
  for (Drive& drive : drives_) drive.path.lose(lostCycles);
}

/// Links of chains that are not replayed here carry it themselves.
void Stepper::takeForces() {
  for (const ExternalForce& external : plant_.forces) {
    const auto carries = [&](const Drive& d) {
      return plant_.mechanism.joints[index(d.joint)].child == external.link;
    };
    if (external.link == 0 || std::ranges::any_of(drives_, carries)) forces_.push_back(&external);
  }
}

ServoTerms::Given Stepper::givenTo(const Drive& drive) const {
  const double loss = drive.plant->deratingPerJoule;
  return {drive.path.stiffness(), drive.path.voltage(), loss > 0 ? std::max(0.0, 1 - loss * drive.heat) : 1,
          supply_.hasVoltageDrop() ? supply_.left(*drive.plant) : 1};
}

DryFriction Stepper::frictionBound(const Drive& drive) const {
  return dryFriction(*drive.plant, v_[drive.motor], drive.load);
}

void Stepper::assemble(double h) {
  const double a = weight_ * h;
  const int rigid = tree_.size(), n = n_;
  double *const A = A_.data(), *const force = force_.data(), *const rhs = rhs_.data();
  const double *const bias = tree_.bias().data(), *const q = q_.data(), *const v = v_.data();
  const auto at = [A, n](int row, int column) -> double& { return A[row + n * column]; };
  if (n == rigid) {
    std::copy_n(tree_.mass().data(), n * n, A);
  } else {
    A_.setZero();
    A_.topLeftCorner(rigid, rigid) = tree_.mass();
  }
  for (int i = 0; i < rigid; ++i) force[i] = -bias[i];
  std::fill(force + rigid, force + n, 0.0);
  for (const ExternalForce* external : forces_) {
    const auto& link = plant_.mechanism.links[index(external->link)];
    tree_.addForce(external->link, tree_.origin(external->link) + tree_.rotation(external->link) * link.com,
                   external->force, force_);
  }
  for (const Drive& drive : drives_) at(drive.motor, drive.motor) += drive.armature;
  rhs_.setZero();
  addColumns(
      rhs, [v](long k) { return v[k]; }, A, n, n);
  for (const Drive& drive : drives_) {
    const JointPlant& p = *drive.plant;
    const ServoLine& line = drive.line;
    double& diagonal = at(drive.motor, drive.motor);
    force[drive.motor] += line.torque - line.stiffness * q[drive.sensed];
    if (drive.sensed == drive.motor) {
      diagonal += a * a * line.stiffness + a * line.damping;
    } else {
      // The servo feels the link across the gear: explicit, for a matrix that stays symmetric.
      force[drive.motor] -= (line.stiffness * a + line.damping) * v[drive.sensed];
    }
    diagonal += a * p.viscous;
    force[drive.link] += p.biasForce;
    for (const JointTorque& torque : p.torques) force[drive.link] += torque(q[drive.link], v[drive.link]);
  }
  for (const Gear& gear : gears_) {
    if (gear.play > 0 && gear.side == 0) continue;
    const Drive& drive = drives_[index(gear.drive)];
    const double stretch = q[drive.motor] - q[drive.link] - gear.side * gear.play / 2;
    const double implicit = a * gear.damping + a * a * gear.stiffness;
    force[drive.motor] -= gear.stiffness * stretch;
    force[drive.link] += gear.stiffness * stretch;
    at(drive.motor, drive.motor) += implicit;
    at(drive.link, drive.link) += implicit;
    at(drive.motor, drive.link) -= implicit;
    at(drive.link, drive.motor) -= implicit;
  }
  for (int i = 0; i < n; ++i) rhs[i] += a * force[i];
}

void Stepper::solve(double h) {
  const auto rows = static_cast<Eigen::Index>(frictions_.size());
  const Eigen::Index width = SmallFactor::fullWidth(rows + 1);
  solved_.setZero(n_, width);
  double* const solved = solved_.data();
  for (Eigen::Index i = 0; i < rows; ++i)
    solved[frictions_[static_cast<std::size_t>(i)].coordinate * width + i] = h;
  double *const u = u_.data(), *const rhs = rhs_.data(), *const fresh = predicted_.data();
  const double* const v = v_.data();
  for (Eigen::Index i = 0; i < n_; ++i) solved[i * width + rows] = rhs[i];
  factor_.computeAndSolve(A_, solved_);
  // Velocity in the step, and at its end.
  const double* end = solved + rows;
  Eigen::Index i = 0;
  for (; i + 1 < n_; i += 2, end += 2 * width) {
    const DoublePair mean{end[0], end[width]}, before = readDoubles<DoublePair>(v + i);
    writeDoubles(u + i, mean);
    writeDoubles(fresh + i, before + (mean - before) / weight_);
  }
  if (i < n_) {
    u[i] = end[0];
    fresh[i] = v[i] + (u[i] - v[i]) / weight_;
  }
  if (rows || contacts_) bind(h);
}

/// Takes frictions and contacts into the new velocity.
void Stepper::bind(double h) {
  const auto rows = static_cast<Eigen::Index>(frictions_.size());
  Eigen::VectorXd& fresh = predicted_;
  columns_.resize(n_, rows);
  // Two at once, as they are read: what is written by one would have to be awaited.
  const Eigen::Index width = solved_.cols();
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double* solved = solved_.data() + i;
    double* column = columns_.data() + i * n_;
    Eigen::Index row = 0;
    for (; row + 1 < n_; row += 2, solved += 2 * width)
      writeDoubles(column + row, DoublePair{solved[0], solved[width]});
    if (row < n_) column[row] = solved[0];
  }
  for (Eigen::Index i = 0; i < rows; ++i) {
    Friction& friction = frictions_[static_cast<std::size_t>(i)];
    friction.mobility = columns_.data()[friction.coordinate + i * n_];
  }
  if (!contacts_) {
    addColumns(
        fresh.data(), [this](long i) { return frictions_[static_cast<std::size_t>(i)].force; },
        columns_.data(), rows, n_);
    sweepFrictions(fresh.data());
  } else {
    unbound_ = fresh;
    pushed_.setZero(n_);
    double hold = 0;
    for (const Friction& friction : frictions_)
      hold += (friction.bound.forward + friction.bound.backward) / 2;
    contacts_->prepare(factor_, h);
    const int rounds = rows ? mostRounds : 1;
    for (int round = 0; round < rounds; ++round) {
      fresh = unbound_ + pushed_;
      for (Eigen::Index i = 0; i < rows; ++i)
        fresh += columns_.col(i) * frictions_[static_cast<std::size_t>(i)].force;
      // What contacts have undone of what frictions hold: else what sticks would creep.
      const double changed = sweepFrictions(fresh.data());
      if (round > 0 && changed <= maxChange * hold) break;
      const Eigen::VectorXd before = fresh - pushed_;
      fresh = before;
      contacts_->solve(h, fresh);
      pushed_ = fresh - before;
    }
  }
  double* const u = u_.data();
  const double *const v = v_.data(), *const end = fresh.data();
  for (Eigen::Index i = 0; i < n_; ++i) u[i] = v[i] + weight_ * (end[i] - v[i]);
}

/// Frictions that hold what moves, each as much as it can, one after the other. Returns by how much the first
/// round changed them [N m]. fresh: the new velocity.
double Stepper::sweepFrictions(double* fresh) {
  double changed = 0;
  const int sweeps = frictions_.size() > 1 ? frictionSweeps : 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double moved = 0;
    const double* column = columns_.data();
    for (Friction& friction : frictions_) {
      const double stopping = friction.force - fresh[friction.coordinate] / friction.mobility;
      const double wanted = std::min(std::max(stopping, -friction.bound.forward), friction.bound.backward);
      const double delta = wanted - friction.force;
      if (delta != 0) {
        addScaled(fresh, delta, column, n_);
        friction.force = wanted;
        moved += std::abs(delta);
      }
      column += n_;
    }
    if (sweep == 0) changed = moved;
    if (moved < 1e-9) break;
  }
  return changed;
}

bool Stepper::regimesHold(double h) {
  const double a = weight_ * h;
  bool same = true;
  const double *const q = q_.data(), *const u = u_.data();
  for (Drive& drive : drives_) {
    const double w = u[drive.sensed];
    const int before = drive.line.regime;
    putServoLine(drive.terms, drive.command, q[drive.sensed] + a * w, w, drive.path.speedSent(),
                 drive.path.torqueSent(), drive.line);
    if (drive.line.regime != before) same = false;
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
    if (const ServoTerms::Given given = givenTo(drive); given != drive.terms.given)
      drive.terms = ServoTerms(*drive.plant, given);
  }
  const double *const q = q_.data(), *const v = v_.data();
  for (Eigen::Index i = 0; i < n_; ++i) {
    u_.data()[i] = v[i];
    qm_.data()[i] = q[i] + a * v[i];
  }
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
    gearsUsed_ = gears_;
    if (regimesHold(h)) break;
    if (round + 1 == maxRegimes) gears_ = gearsUsed_;
  }
  advance(h);
  if (imuIsLate_) sampleImu(to);
}

void Stepper::advance(double h) {
  double *const q = q_.data(), *const v = v_.data(), *const acceleration = acceleration_.data();
  const double *const u = u_.data(), *const fresh = predicted_.data();
  if (trial_.freeBase)
    for (Eigen::Index i = 0; i < tree_.size(); ++i) acceleration[i] = (fresh[i] - v[i]) / h;
  double torques = 0;
  for (Drive& drive : drives_) {
    drive.torque = drive.line.at(q[drive.sensed] + weight_ * h * u[drive.sensed], u[drive.sensed]);
    drive.heat += h * std::abs(drive.torque) *
                  (drive.plant->heatIsWork ? std::abs(u[drive.motor]) : std::abs(drive.torque));
    const double gear = drive.torque - drive.armature * (fresh[drive.motor] - v[drive.motor]) / h;
    drive.load = {drive.torque, gear, gear};
    torques += std::abs(drive.torque);
  }
  for (const Friction& friction : frictions_) drives_[index(friction.drive)].load.link += friction.force;
  supply_.take(torques, h);
  for (Eigen::Index i = 0; i < n_; ++i) {
    q[i] += h * u[i];
    v[i] = fresh[i];
  }
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
    drive.shown = measuredAngle(*drive.plant, q[drive.sensed]);
    drive.rate = v[drive.sensed];
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
  const JointPlant& plant = *drive.plant;
  // The encoder's error changes slowly enough to be taken at the reading.
  const double angle = 2 * shown - measuredAngle(plant, shown);
  return servoLine(ServoTerms(plant, givenTo(drive)), drive.path.atEnd(), angle, rate, drive.path.speedSent(),
                   drive.path.torqueSent())
      .at(angle, rate);
}

double Stepper::duty(int node, double shown) const {
  const Drive& drive = drives_[index(node)];
  return dutyOf(*drive.plant, drive.path.atEnd(), shown);
}

}  // namespace plumbline::gap
