#include "servo/BulletRobot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "math/Index.h"

namespace plumbline::servo {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double ballRadius = 0.03;  ///< of links that are no feet [m]
constexpr double stopErp = 0.2;      ///< share of a joint's way beyond its stop undone in a step
constexpr double leastRotor = 1e-9;  ///< a row needs some softness [kg m^2]
constexpr double creep = 1e-5;       ///< of contacts that stick [m/(s N)]
constexpr int mostRounds = 12;       ///< of solving with more and more limits reached
constexpr double rotorMass =
    1e-6;  ///< of a rotor's own body; what turns with it is the servo's armature [kg]

int stepsIn(double hz, double step) {
  if (!(step > 0) || !(hz > 0))
    throw std::invalid_argument("Bullet robot: the step and the control rate must be above zero");
  return std::max(1, static_cast<int>(std::ceil(1 / hz / step - 1e-9)));
}

/// Adds a rotor for every joint whose motor turns apart from its link; motors: which joint each motor turns.
Mechanism withRotors(const Mechanism& robot, const std::vector<JointPlant>& drives,
                     std::vector<int>& motors) {
  Mechanism result = robot;
  motors.clear();
  for (int i = 0; i < robot.numJoints(); ++i) {
    motors.push_back(i);
    if (drives.empty() || !drives[at(i)].geared()) continue;
    motors.back() = result.numJoints();
    Mechanism::Joint rotor = robot.joints[at(i)];
    rotor.name += " motor";
    rotor.child = static_cast<int>(result.links.size());
    Mechanism::Link body;
    body.name = rotor.name;
    body.parent = rotor.parent;
    body.mass = rotorMass;
    body.inertia = rotorMass * Mat3::Identity();
    result.joints.push_back(rotor);
    result.links.push_back(body);
  }
  return result;
}

}  // namespace

MAKE_ROBOT_SIMULATION("bullet", BulletRobot)

BulletRobot::BulletRobot(const Mechanism& mechanism, const RobotSimulationOptions& config)
    : mechanism_(mechanism),
      config_(config),
      stepsPerCycle_(stepsIn(mechanism.controlHz, config.stepSeconds)),
      h_(1 / mechanism.controlHz / stepsPerCycle_),
      supply_(config.drives) {
  const bool detailed = !config_.drives.empty();
  if (detailed && config_.drives.size() != mechanism_.joints.size())
    throw std::invalid_argument("Bullet robot: " + std::to_string(config_.drives.size()) + " drives for " +
                                std::to_string(mechanism_.numJoints()) + " joints");
  for (std::size_t i = 0; i < mechanism_.joints.size(); ++i)
    drives_.emplace_back(detailed ? config_.drives[i] : JointPlant::nominal(mechanism_.joints[i]), detailed);
  geared_ = withRotors(mechanism_, config_.drives, motors_);
  loads_.assign(mechanism_.joints.size(), 0);
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
      points_.push_back(point);
    }
  }
  for (std::size_t i = 0; i < mechanism_.links.size(); ++i)
    if (!isFoot[i]) {
      Point point;
      point.link = static_cast<int>(i);
      point.local = mechanism_.links[i].com;
      point.radius = ballRadius;
      points_.push_back(point);
    }
  restart(Pose3::Identity(), std::vector<double>(at(mechanism_.numJoints()), 0));
}

void BulletRobot::restart(const Pose3& T_world_base, const std::vector<double>& q) {
  if (static_cast<int>(q.size()) != mechanism_.numJoints())
    throw std::invalid_argument("Bullet robot: " + std::to_string(q.size()) + " positions for " +
                                std::to_string(mechanism_.numJoints()) + " joints");
  // Only a new multi-body has no trace of the past.
  body_ = std::make_unique<BulletMultiBody>(geared_, config_.fixedBase);
  std::vector<double> start = q;
  for (std::size_t i = 0; i < q.size(); ++i)
    if (const Mechanism::Joint& joint = mechanism_.joints[i]; joint.driver >= 0)
      start[i] = joint.driven(start[at(joint.driver)]);
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    drives_[i].start(start[i]);
    if (motors_[i] >= mechanism_.numJoints()) start.push_back(start[i]);
  }
  supply_.restart();
  body_->place(T_world_base, start);
  loads_.assign(q.size(), 0);
  for (Point& point : points_) point.force.setZero();
  pushSteps_ = cycles_ = 0;
  torqueSum_.assign(q.size(), 0);
  readings_ = {};
  senseImu();
  sense();
  readings_.acc = rotationOfRpy(mechanism_.imu.rpy).transpose() *
                  (link(mechanism_.imu.link).pose.linear().transpose() * Vec3(-mechanism_.gravity));
}

void BulletRobot::restart(const std::vector<double>& q, double heading) {
  restart(rotationZ(heading), q);
  double lowest = unbounded;
  for (const Point& point : points_)
    lowest = std::min(lowest, (link(point.link).pose * point.local).z() - point.radius);
  restart(translation(0, 0, -lowest) * rotationZ(heading), q);
}

void BulletRobot::command(const std::vector<double>& targets) {
  if (targets.size() != drives_.size())
    throw std::invalid_argument("Bullet robot: " + std::to_string(targets.size()) + " targets for " +
                                std::to_string(drives_.size()) + " joints");
  for (std::size_t i = 0; i < drives_.size(); ++i)
    if (!std::isfinite(targets[i]))
      throw std::invalid_argument("Bullet robot: target of " + mechanism_.joints[i].name + " is not finite");
  for (std::size_t i = 0; i < drives_.size(); ++i) drives_[i].command(targets[i]);
}

void BulletRobot::setStiffness(int joint, double stiffness) {
  drives_.at(at(joint)).setStiffness(std::clamp(stiffness, 0.0, 1.0));
}

void BulletRobot::push(const Vec3& force, double seconds, int link) {
  static_cast<void>(mechanism_.links.at(at(link)));
  pushForce_ = force;
  pushLink_ = link;
  pushSteps_ = std::lround(seconds / h_);
}

void BulletRobot::step() {
  const Vec3 before = imuVelocity_;
  std::fill(torqueSum_.begin(), torqueSum_.end(), 0.0);
  for (int i = 0; i < stepsPerCycle_; ++i) substep();
  ++cycles_;
  senseImu();
  const double seconds = stepsPerCycle_ * h_;
  const Mat3 toSensor =
      (link(mechanism_.imu.link).pose.linear() * rotationOfRpy(mechanism_.imu.rpy)).transpose();
  readings_.acc = toSensor * ((imuVelocity_ - before) / seconds - mechanism_.gravity);
  sense();
}

void BulletRobot::substep() {
  if (pushSteps_ > 0) {
    --pushSteps_;
    body_->addForce(pushLink_, pushForce_, link(pushLink_).pose * mechanism_.links[at(pushLink_)].com);
  }
  for (int i = 0; i < mechanism_.numJoints(); ++i) {
    // With the speeds before gravity and forces have moved it on.
    drives_[at(i)].begin(h_, {body_->position(motor(i)), body_->velocity(motor(i))},
                         {body_->position(i), body_->velocity(i)});
    double load = loads_[at(i)] + drives_[at(i)].drive().biasForce;
    for (const JointTorque& torque : drives_[at(i)].drive().torques)
      load += torque(body_->position(i), body_->velocity(i));
    if (load != 0) body_->addTorque(i, load);
  }
  body_->begin(mechanism_.gravity, h_);
  rows_.clear();
  for (int i = 0; i < mechanism_.numJoints(); ++i) addServoRow(i);
  for (int i = 0; i < mechanism_.numJoints(); ++i) {
    addGearRow(i);
    addFrictionRows(i);
  }
  for (int i = 0; i < mechanism_.numJoints(); ++i) addStopRow(i);
  for (std::size_t i = 0; i < points_.size(); ++i) addContactRows(static_cast<int>(i));
  solve();
  takeForces();
  body_->finish(impulses_, h_);
}

void BulletRobot::addRow(const Row& row, int local) {
  body_->rows().place(local, static_cast<Eigen::Index>(rows_.size()));
  rows_.push_back(row);
}

void BulletRobot::addServoRow(int joint) {
  const Mechanism::Joint& spec = mechanism_.joints[at(joint)];
  if (spec.driver >= 0) {
    const double gap = body_->position(joint) - spec.driven(body_->position(spec.driver));
    addRow({Row::Kind::drive, joint, -stopErp / h_ * gap, 1e-9, -unbounded, unbounded},
           body_->addDriveRow(joint, spec.driver, spec.driverRatio));
    return;
  }
  addRow({Row::Kind::servo, joint, 0, 0, -unbounded, unbounded}, body_->addJointRow(motor(joint)));
}

/// A spring and a damper between motor and link, as contacts have them; with play it pushes only at its ends.
void BulletRobot::addGearRow(int joint) {
  if (motor(joint) == joint) return;
  const JointPlant& drive = drives_[at(joint)].drive();
  const double k = drive.compliance > 0 ? 1 / drive.compliance : drive.toothStiffness;
  const double d = (drive.compliance > 0 ? 0.1 : 2 * drive.toothDamping) *
                   std::sqrt(k * std::max(drive.servo.armature, leastRotor));
  const double apart = body_->position(joint) - body_->position(motor(joint));
  const double beyond = apart - std::clamp(apart, -drive.backlash / 2, drive.backlash / 2);
  if (drive.backlash > 0 && beyond == 0) return;
  const double soft = 1 / (h_ * h_ * k + h_ * d);
  const bool oneWay = drive.backlash > 0;
  addRow({Row::Kind::gear, joint, soft * h_ * k * -beyond, soft, oneWay && beyond < 0 ? 0 : -unbounded,
          oneWay && beyond > 0 ? 0 : unbounded},
         body_->addDriveRow(joint, motor(joint), 1));
}

/// Both at the motor.
void BulletRobot::addFrictionRows(int joint) {
  const double viscous = drives_[at(joint)].drive().viscous;
  const DryFriction dry = drives_[at(joint)].dryLimit();
  if (viscous > 0)
    addRow({Row::Kind::viscous, joint, 0, 1 / (h_ * viscous), -unbounded, unbounded},
           body_->addJointRow(motor(joint)));
  if (dry.forward > 0 || dry.backward > 0)
    addRow({Row::Kind::dry, joint, 0, 1e-9, -h_ * dry.forward, h_ * dry.backward},
           body_->addJointRow(motor(joint)));
}

void BulletRobot::addStopRow(int joint) {
  const Mechanism::Joint& spec = mechanism_.joints[at(joint)];
  if (spec.driver >= 0) return;
  const double q = body_->position(joint);
  const double beyond = q < spec.lower ? q - spec.lower : q > spec.upper ? q - spec.upper : 0;
  if (beyond == 0) return;
  addRow({Row::Kind::stop, joint, -stopErp / h_ * beyond, 1e-9, beyond < 0 ? 0 : -unbounded,
          beyond < 0 ? unbounded : 0},
         body_->addJointRow(joint));
}

void BulletRobot::addContactRows(int index) {
  Point& point = points_[at(index)];
  point.force.setZero();
  point.world = link(point.link).pose * point.local - Vec3(0, 0, point.radius);
  if (config_.fixedBase || point.world.z() > 0) return;
  const double k = config_.groundStiffness, d = config_.groundDamping;
  // A spring and a damper with their force at the end of the step.
  const double soft = 1 / (h_ * h_ * k + h_ * d);
  addRow({Row::Kind::push, index, soft * h_ * k * -point.world.z(), soft, 0, unbounded},
         body_->addPointRow(point.link, point.world, Vec3::UnitZ()));
  for (const Vec3& across : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())})
    addRow({Row::Kind::friction, index, 0, creep / h_, -unbounded, unbounded},
           body_->addPointRow(point.link, point.world, across));
}

/// impulse = h (offset - slope v) + rotor (v before - v), as a row v + impulse / (h slope + rotor) = wanted.
void BulletRobot::setLaw(std::size_t row) {
  const int joint = rows_[row].index;
  const ServoDrive& drive = drives_[at(joint)];
  const double rotor = std::max(drive.rotor(), leastRotor);
  const double soft = 1 / (h_ * drive.slope() + rotor);
  const auto i = static_cast<Eigen::Index>(row);
  system_.a(i, i) += soft - rows_[row].compliance;
  system_.b[i] += soft * (h_ * drive.offset() + rotor * drive.speedAtBegin()) - rows_[row].wanted;
  rows_[row].compliance = soft;
  rows_[row].wanted = soft * (h_ * drive.offset() + rotor * drive.speedAtBegin());
}

void BulletRobot::solve() {
  system_.reset(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const auto i = static_cast<Eigen::Index>(r);
    system_.a(i, i) = rows_[r].compliance;
    system_.b[i] = rows_[r].wanted;
    system_.lower[i] = rows_[r].lower;
    system_.upper[i] = rows_[r].upper;
  }
  body_->rows().addTo(system_);
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (rows_[r].kind == Row::Kind::servo) setLaw(r);
  for (int round = 0; round < mostRounds; ++round) {
    system_.solve();
    const bool servos = limitServos(), contacts = limitFriction();
    if (!servos && !contacts) break;
  }
  impulses_ = system_.solution();
}

/// Limits servos that would need more torque than they have; returns whether there were any.
bool BulletRobot::limitServos() {
  bool changed = false;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (rows_[r].kind != Row::Kind::servo) continue;
    const double velocity =
        rows_[r].wanted - rows_[r].compliance * system_.solution()[static_cast<Eigen::Index>(r)];
    if (!drives_[at(rows_[r].index)].limitAt(velocity)) continue;
    setLaw(r);
    changed = true;
  }
  return changed;
}

/// Keeps friction within its cone; returns whether that changed anything.
bool BulletRobot::limitFriction() {
  bool changed = false;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (rows_[r].kind != Row::Kind::push) continue;
    const auto i = static_cast<Eigen::Index>(r);
    const double most = config_.groundFriction * std::max(0.0, system_.solution()[i]);
    const Vec2 friction = system_.solution().segment<2>(i + 1);
    const double size = friction.norm();
    if (size <= most * (1 + 1e-6) + 1e-12) continue;
    for (int k = 0; k < 2; ++k) {
      // Along each axis what the cone has in the direction in which the point would be held.
      const double bound = size > 0 ? most * std::abs(friction[k]) / size : 0;
      system_.lower[i + 1 + k] = -bound;
      system_.upper[i + 1 + k] = bound;
    }
    changed = true;
  }
  return changed;
}

void BulletRobot::takeForces() {
  frictions_.assign(drives_.size(), 0);
  double torques = 0;
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (rows_[r].kind == Row::Kind::dry)
      frictions_[at(rows_[r].index)] = impulses_[static_cast<Eigen::Index>(r)] / h_;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const auto i = static_cast<Eigen::Index>(r);
    const Row& row = rows_[r];
    if (row.kind == Row::Kind::push)
      points_[at(row.index)].force = Vec3(impulses_[i + 1], impulses_[i + 2], impulses_[i]) / h_;
    if (row.kind == Row::Kind::servo) {
      const double velocity = row.wanted - row.compliance * impulses_[i];
      drives_[at(row.index)].end(velocity, frictions_[at(row.index)]);
      torqueSum_[at(row.index)] += drives_[at(row.index)].torque(velocity);
      torques += std::abs(drives_[at(row.index)].torque(velocity));
    }
  }
  if (!supply_.hasVoltageDrop()) return;
  supply_.take(torques, h_);
  for (ServoDrive& drive : drives_) drive.setSupply(supply_.left(drive.drive()));
}

ServoDrive::Side BulletRobot::motorSide(int joint) const {
  return {body_->position(motor(joint)), body_->velocity(motor(joint))};
}

ServoDrive::Side BulletRobot::linkSide(int joint) const {
  return {body_->position(joint), body_->velocity(joint)};
}

}  // namespace plumbline::servo
