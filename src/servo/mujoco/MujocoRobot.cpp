#include "servo/mujoco/MujocoRobot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "math/Index.h"
#include "servo/FootSensors.h"
#include "servo/mujoco/MujocoModel.h"

namespace plumbline::servo::mujoco {

MAKE_ROBOT_SIMULATION("mujoco", MujocoRobot)

namespace {

constexpr double longestStep = 1e-3, longestGearedStep = 1e-4;  // [s]: explicit gears and limits stay calm
constexpr double hardGround = 4.9e5;  ///< [N/m]: from here on the engine's own contacts
constexpr double leastRotor = 1e-5;   // [kg m^2]
constexpr double noFriction = 1e-9;   ///< the engine keeps a row of friction only for what is above 0 [N m]

int stepsIn(double hz, double step) {
  if (!(step > 0) || !(hz > 0))
    throw std::invalid_argument("mujoco: the step and the control rate must be above zero");
  return std::max(1, static_cast<int>(std::ceil(1 / hz / step - 1e-9)));
}

}  // namespace

MujocoRobot::MujocoRobot(const Mechanism& mechanism, const RobotSimulationOptions& options)
    : robot_(mechanism), options_(options), supply_(options.drives) {
  const std::size_t count = robot_.joints.size();
  const bool detailed = !options_.drives.empty();
  if (detailed && options_.drives.size() != count)
    throw std::invalid_argument("mujoco: " + std::to_string(options_.drives.size()) + " drives for " +
                                std::to_string(count) + " joints");
  bool anyGear = false;
  ModelOptions model;
  for (std::size_t j = 0; j < count; ++j) {
    drives_.emplace_back(detailed ? options_.drives[j] : JointPlant::nominal(robot_.joints[j]), detailed);
    const JointPlant& plant = drives_[j].drive();
    anyGear = anyGear || plant.geared();
    model.geared.push_back(plant.geared());
    model.armature.push_back(std::max(leastRotor, plant.servo.armature));
    model.damping.push_back(0);
    model.hasFriction.push_back(plant.hasFriction());
  }
  stepsPerCycle_ =
      stepsIn(robot_.controlHz, std::min(options_.stepSeconds, anyGear ? longestGearedStep : longestStep));
  h_ = 1 / robot_.controlHz / stepsPerCycle_;
  model.freeBase = !options_.fixedBase;
  model.step = h_;
  model.groundFriction = options_.groundFriction;
  if (!options_.fixedBase && options_.groundStiffness < hardGround)
    ground_ = std::make_unique<SoftGround>(robot_, 1 / options_.groundStiffness, options_.groundFriction,
                                           Mat3(Mat3::Identity()));
  model.engineContacts = !ground_;
  world_ = std::make_unique<World>(robot_, modelText(robot_, model));
  stiffGear_.assign(count, 0);
  for (std::size_t j = 0; j < count; ++j) {
    const JointPlant& plant = drives_[j].drive();
    if (!plant.geared()) continue;
    const World::Address& a = world_->joint(j);
    const double lightest =
        std::min(world_->model()->dof_M0[a.velocity], world_->model()->dof_M0[a.rotorVelocity]);
    const double stiffness = plant.compliance > 0 ? 1 / plant.compliance : plant.toothStiffness;
    stiffGear_[j] = std::min(stiffness, 0.1 * lightest / (h_ * h_));
  }
  restart(Pose3::Identity(), std::vector<double>(count, 0));
}

void MujocoRobot::restart(const Pose3& T_world_base, const std::vector<double>& q) {
  if (q.size() != drives_.size())
    throw std::invalid_argument("mujoco: " + std::to_string(q.size()) + " positions for " +
                                std::to_string(drives_.size()) + " joints");
  mjModel* m = world_->model();
  mjData* d = world_->data();
  mj_resetData(m, d);
  const Eigen::Quaterniond turn(T_world_base.linear());
  const Vec3 place = T_world_base.translation();
  const double pose[7] = {place.x(), place.y(), place.z(), turn.w(), turn.x(), turn.y(), turn.z()};
  if (options_.fixedBase) {
    std::copy(pose, pose + 3, m->body_pos + 3 * world_->body(0));
    std::copy(pose + 3, pose + 7, m->body_quat + 4 * world_->body(0));
  } else {
    std::copy(pose, pose + 7, d->qpos);
  }
  std::vector<double> start = q;
  supply_.restart();
  for (std::size_t j = 0; j < q.size(); ++j) {
    if (const Mechanism::Joint& joint = robot_.joints[j]; joint.driver >= 0)
      start[j] = joint.driven(start[at(joint.driver)]);
    d->qpos[world_->joint(j).position] = d->qpos[world_->joint(j).rotorPosition] = start[j];
    drives_[j].start(start[j]);
  }
  if (ground_)
    for (SoftGround::Corner& corner : ground_->corners()) corner.touches = false;
  loads_.assign(q.size(), 0);
  torqueSum_.assign(q.size(), 0);
  pushSteps_ = cycles_ = 0;
  sensed_ = {};
  mj_forward(m, d);
  update();
  sense();
  sensed_.acc = rotationOfRpy(robot_.imu.rpy).transpose() *
                (link(robot_.imu.link).pose.linear().transpose() * Vec3(-robot_.gravity));
}

void MujocoRobot::restart(const std::vector<double>& q, double heading) {
  restart(rotationZ(heading), q);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Mechanism::Foot& foot : robot_.feet)
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      const Vec3 local = foot.soleCentre + foot.soleSize.cwiseProduct(sign);
      lowest = std::min(lowest, (link(foot.link).pose * local).z());
    }
  if (robot_.feet.empty()) lowest = 0;
  restart(translation(0, 0, -lowest) * rotationZ(heading), q);
}

void MujocoRobot::command(const std::vector<double>& targets) {
  if (targets.size() != drives_.size())
    throw std::invalid_argument("mujoco: " + std::to_string(targets.size()) + " targets for " +
                                std::to_string(drives_.size()) + " joints");
  for (std::size_t j = 0; j < targets.size(); ++j)
    if (!std::isfinite(targets[j]))
      throw std::invalid_argument("mujoco: target of " + robot_.joints[j].name + " is not finite");
  for (std::size_t j = 0; j < targets.size(); ++j) {
    const Mechanism::Joint& joint = robot_.joints[j];
    drives_[j].command(joint.driver >= 0 ? joint.driven(targets[at(joint.driver)]) : targets[j]);
  }
}

void MujocoRobot::setStiffness(int joint, double stiffness) {
  drives_.at(at(joint)).setStiffness(std::clamp(stiffness, 0.0, 1.0));
}

void MujocoRobot::push(const Vec3& force, double seconds, int link) {
  static_cast<void>(robot_.links.at(at(link)));
  pushForce_ = force;
  pushLink_ = link;
  pushSteps_ = std::lround(seconds / h_);
}

ServoDrive::Side MujocoRobot::motorSide(std::size_t joint) const {
  const World::Address& a = world_->joint(joint);
  return {world_->data()->qpos[a.rotorPosition], world_->data()->qvel[a.rotorVelocity]};
}

ServoDrive::Side MujocoRobot::linkSide(std::size_t joint) const {
  const World::Address& a = world_->joint(joint);
  return {world_->data()->qpos[a.position], world_->data()->qvel[a.velocity]};
}

double MujocoRobot::encoder(int joint) const {
  return drives_.at(at(joint)).measured(motorSide(at(joint)), linkSide(at(joint)));
}

double MujocoRobot::encoderSpeed(int joint) const {
  return (drives_.at(at(joint)).drive().linkEncoder ? linkSide(at(joint)) : motorSide(at(joint))).speed;
}

/// From motor to link: a spring and a damper, with play only at its ends.
double MujocoRobot::gearTorque(std::size_t joint) const {
  const JointPlant& plant = drives_[joint].drive();
  const ServoDrive::Side motor = motorSide(joint), link = linkSide(joint);
  const double apart = motor.position - link.position;
  const double beyond = apart - std::clamp(apart, -plant.backlash / 2, plant.backlash / 2);
  if (plant.backlash > 0 && beyond == 0) return 0;
  const double rotor = std::max(leastRotor, plant.servo.armature);
  const double damping =
      (plant.compliance > 0 ? 0.1 : 2 * plant.toothDamping) * std::sqrt(stiffGear_[joint] * rotor);
  const double torque = stiffGear_[joint] * beyond + damping * (motor.speed - link.speed);
  // Flanks push and never pull.
  return plant.backlash > 0 && torque * beyond < 0 ? 0 : torque;
}

void MujocoRobot::drive(std::size_t joint) {
  mjModel* m = world_->model();
  mjData* d = world_->data();
  ServoDrive& servo = drives_[joint];
  const World::Address& a = world_->joint(joint);
  const ServoDrive::Side motor = motorSide(joint);
  servo.begin(h_, motor, linkSide(joint));
  for (int regime = 0; regime < 4 && servo.limitAt(motor.speed);) ++regime;
  d->qfrc_applied[a.rotorVelocity] += servo.offset();
  // The engine solves the damping with the step.
  m->dof_damping[a.rotorVelocity] = servo.slope() + servo.drive().viscous;
  double load = loads_[joint] + servo.drive().biasForce;
  const ServoDrive::Side link = linkSide(joint);
  for (const JointTorque& torque : servo.drive().torques) load += torque(link.position, link.speed);
  d->qfrc_applied[a.velocity] += load;
  if (servo.drive().geared()) {
    const double torque = gearTorque(joint);
    d->qfrc_applied[a.rotorVelocity] -= torque;
    d->qfrc_applied[a.velocity] += torque;
  }
  if (!servo.drive().hasFriction()) return;
  // The engine knows one limit for both ways: what differs is a torque that pushes towards the easier one.
  const DryFriction dry = servo.dryLimit();
  m->dof_frictionloss[a.rotorVelocity] = std::max(noFriction, (dry.forward + dry.backward) / 2);
  d->qfrc_applied[a.rotorVelocity] += (dry.backward - dry.forward) / 2;
}

void MujocoRobot::pressGround() {
  for (SoftGround::Corner& corner : ground_->corners()) {
    const auto link = static_cast<std::size_t>(corner.link);
    const Vec3 place = world_->pose(link) * corner.local;
    ground_->update(corner, place, world_->velocity(link, place));
    const double none[3] = {0, 0, 0};
    if (corner.normal > 0)
      mj_applyFT(world_->model(), world_->data(), corner.force.data(), none, place.data(), world_->body(link),
                 world_->data()->qfrc_applied);
  }
}

/// Torque of dry friction at a degree of freedom [N m].
double MujocoRobot::dryFriction(int velocity) const {
  const mjData* d = world_->data();
  for (int row = d->ne; row < d->ne + d->nf; ++row)
    if (d->efc_type[row] == mjCNSTR_FRICTION_DOF && d->efc_id[row] == velocity) return d->efc_force[row];
  return 0;
}

void MujocoRobot::substep() {
  mjModel* m = world_->model();
  mjData* d = world_->data();
  std::fill(d->qfrc_applied, d->qfrc_applied + m->nv, 0.0);
  double* force = d->xfrc_applied + 6 * world_->body(at(pushLink_));
  std::fill(force, force + 6, 0.0);
  if (pushSteps_ > 0) {
    --pushSteps_;
    std::copy(pushForce_.data(), pushForce_.data() + 3, force);
  }
  for (std::size_t j = 0; j < drives_.size(); ++j) drive(j);
  if (ground_) pressGround();
  mj_step(m, d);
  if ((m->nv > 0 && !std::isfinite(d->qacc[0])) || d->warning[mjWARN_BADQACC].number > 0)
    throw std::runtime_error("mujoco: the simulation of " + robot_.name +
                             " broke down; give it shorter steps");
  double torques = 0;
  for (std::size_t j = 0; j < drives_.size(); ++j) {
    const double speed = motorSide(j).speed;
    double friction = 0;
    if (drives_[j].drive().hasFriction()) {
      const DryFriction dry = drives_[j].dryLimit();
      friction = dryFriction(world_->joint(j).rotorVelocity) + (dry.backward - dry.forward) / 2;
    }
    drives_[j].end(speed, friction);
    torqueSum_[j] += drives_[j].torque(speed);
    torques += std::abs(drives_[j].torque(speed));
  }
  if (!supply_.hasVoltageDrop()) return;
  supply_.take(torques, h_);
  for (ServoDrive& servo : drives_) servo.setSupply(supply_.left(servo.drive()));
}

void MujocoRobot::step() {
  const Vec3 before = imuVelocity_;
  std::fill(torqueSum_.begin(), torqueSum_.end(), 0.0);
  for (int i = 0; i < stepsPerCycle_; ++i) substep();
  ++cycles_;
  // Poses and velocities of the links are those at the start of the step until they are read.
  mj_kinematics(world_->model(), world_->data());
  mj_comPos(world_->model(), world_->data());
  mj_comVel(world_->model(), world_->data());
  update();
  const Mat3 toSensor = (link(robot_.imu.link).pose.linear() * rotationOfRpy(robot_.imu.rpy)).transpose();
  const Vec3 acc = toSensor * ((imuVelocity_ - before) * robot_.controlHz - robot_.gravity);
  sense();
  sensed_.acc = acc;
}

/// States of the links, and the accelerometer's velocity.
void MujocoRobot::update() {
  states_.resize(robot_.links.size());
  for (std::size_t i = 0; i < states_.size(); ++i) {
    simulation::BodyState& state = states_[i];
    state.pose = world_->pose(i);
    state.angularVelocity = Eigen::Map<const Vec3>(world_->data()->cvel + 6 * world_->body(i));
    state.linearVelocity = world_->velocity(i, state.pose.translation());
  }
  const simulation::BodyState& carrier = link(robot_.imu.link);
  imuVelocity_ = carrier.linearVelocity +
                 carrier.angularVelocity.cross(carrier.pose.linear() * robot_.imu.accelerometer);
}

void MujocoRobot::sense() {
  sensed_.time = static_cast<double>(cycles_) * stepsPerCycle_ * h_;
  sensed_.position.resize(drives_.size());
  sensed_.velocity.resize(drives_.size());
  sensed_.torque.resize(drives_.size());
  for (std::size_t j = 0; j < drives_.size(); ++j) {
    sensed_.position[j] = linkSide(j).position;
    sensed_.velocity[j] = linkSide(j).speed;
    sensed_.torque[j] = torqueSum_[j] / stepsPerCycle_;
  }
  const simulation::BodyState& carrier = link(robot_.imu.link);
  sensed_.gyro =
      (carrier.pose.linear() * rotationOfRpy(robot_.imu.rpy)).transpose() * carrier.angularVelocity;
  sensed_.footForce.clear();
  for (std::size_t f = 0; f < robot_.feet.size(); ++f) sensed_.footForce.push_back(footForces(f));
}

std::vector<double> MujocoRobot::footForces(std::size_t index) const {
  const Mechanism::Foot& foot = robot_.feet[index];
  World::FootForce force;
  if (ground_) {
    const Mat3 toFoot = link(foot.link).pose.linear().transpose();
    for (const SoftGround::Corner& corner : ground_->corners()) {
      if (corner.foot != static_cast<int>(index)) continue;
      const double normal = (toFoot * corner.force).z();
      force.normal += normal;
      force.moment += normal * corner.local.head<2>();
    }
  } else if (!options_.fixedBase) {
    force = world_->footForce(foot.name, at(foot.link));
  }
  const Vec2 centre = force.normal > 0 ? Vec2(force.moment / force.normal) : Vec2(Vec2::Zero());
  return footSensorForces(foot, force.normal, centre);
}

}  // namespace plumbline::servo::mujoco
