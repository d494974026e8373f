#include "simulation/servo/mujoco/MujocoRobot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "math/Index.h"
#include "simulation/servo/FootSensors.h"
#include "simulation/servo/mujoco/MujocoModel.h"

namespace plumbline::simulation::mujoco {

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

MujocoRobot::MujocoRobot(const Mechanism& mechanism, const RobotSimulationOptions& options_)
    : robot(mechanism), options(options_), supply(options_.drives) {
  const std::size_t count = robot.joints.size();
  const bool detailed = !options.drives.empty();
  if (detailed && options.drives.size() != count)
    throw std::invalid_argument("mujoco: " + std::to_string(options.drives.size()) + " drives for " +
                                std::to_string(count) + " joints");
  bool anyGear = false;
  ModelOptions model;
  for (std::size_t j = 0; j < count; ++j) {
    drives.emplace_back(detailed ? options.drives[j] : JointPlant::nominal(robot.joints[j]), detailed);
    const JointPlant& plant = drives[j].drive();
    anyGear = anyGear || plant.geared();
    model.geared.push_back(plant.geared());
    model.armature.push_back(std::max(leastRotor, plant.servo.armature));
    model.damping.push_back(0);
    model.rubs.push_back(plant.rubs());
  }
  stepsPerCycle =
      stepsIn(robot.controlHz, std::min(options.stepSeconds, anyGear ? longestGearedStep : longestStep));
  h = 1 / robot.controlHz / stepsPerCycle;
  model.freeBase = !options.fixedBase;
  model.step = h;
  model.groundFriction = options.groundFriction;
  if (!options.fixedBase && options.groundStiffness < hardGround)
    ground = std::make_unique<SoftGround>(robot, 1 / options.groundStiffness, options.groundFriction,
                                          Mat3(Mat3::Identity()));
  model.engineContacts = !ground;
  world = std::make_unique<World>(robot, modelText(robot, model));
  stiffGear.assign(count, 0);
  for (std::size_t j = 0; j < count; ++j) {
    const JointPlant& plant = drives[j].drive();
    if (!plant.geared()) continue;
    const World::Address& a = world->joint(j);
    const double lightest =
        std::min(world->model()->dof_M0[a.velocity], world->model()->dof_M0[a.rotorVelocity]);
    const double stiffness = plant.compliance > 0 ? 1 / plant.compliance : plant.toothStiffness;
    stiffGear[j] = std::min(stiffness, 0.1 * lightest / (h * h));
  }
  restart(Pose3::Identity(), std::vector<double>(count, 0));
}

void MujocoRobot::restart(const Pose3& T_world_base, const std::vector<double>& q) {
  if (q.size() != drives.size())
    throw std::invalid_argument("mujoco: " + std::to_string(q.size()) + " positions for " +
                                std::to_string(drives.size()) + " joints");
  mjModel* m = world->model();
  mjData* d = world->data();
  mj_resetData(m, d);
  const Eigen::Quaterniond turn(T_world_base.linear());
  const Vec3 place = T_world_base.translation();
  const double pose[7] = {place.x(), place.y(), place.z(), turn.w(), turn.x(), turn.y(), turn.z()};
  if (options.fixedBase) {
    std::copy(pose, pose + 3, m->body_pos + 3 * world->body(0));
    std::copy(pose + 3, pose + 7, m->body_quat + 4 * world->body(0));
  } else {
    std::copy(pose, pose + 7, d->qpos);
  }
  std::vector<double> start = q;
  supply.restart();
  for (std::size_t j = 0; j < q.size(); ++j) {
    if (const Mechanism::Joint& joint = robot.joints[j]; joint.driver >= 0)
      start[j] = joint.driven(start[at(joint.driver)]);
    d->qpos[world->joint(j).position] = d->qpos[world->joint(j).rotorPosition] = start[j];
    drives[j].start(start[j]);
  }
  if (ground)
    for (SoftGround::Corner& corner : ground->corners()) corner.touches = false;
  loads.assign(q.size(), 0);
  torqueSum.assign(q.size(), 0);
  pushSteps = cycles = 0;
  sensed = {};
  mj_forward(m, d);
  update();
  sense();
  sensed.acc = rotationOfRpy(robot.imu.rpy).transpose() *
               (link(robot.imu.link).pose.linear().transpose() * Vec3(-robot.gravity));
}

void MujocoRobot::restart(const std::vector<double>& q, double heading) {
  restart(rotationZ(heading), q);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Mechanism::Foot& foot : robot.feet)
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      const Vec3 local = foot.soleCentre + foot.soleSize.cwiseProduct(sign);
      lowest = std::min(lowest, (link(foot.link).pose * local).z());
    }
  if (robot.feet.empty()) lowest = 0;
  restart(translation(0, 0, -lowest) * rotationZ(heading), q);
}

void MujocoRobot::command(const std::vector<double>& targets) {
  if (targets.size() != drives.size())
    throw std::invalid_argument("mujoco: " + std::to_string(targets.size()) + " targets for " +
                                std::to_string(drives.size()) + " joints");
  for (std::size_t j = 0; j < targets.size(); ++j)
    if (!std::isfinite(targets[j]))
      throw std::invalid_argument("mujoco: target of " + robot.joints[j].name + " is not finite");
  for (std::size_t j = 0; j < targets.size(); ++j) {
    const Mechanism::Joint& joint = robot.joints[j];
    drives[j].command(joint.driver >= 0 ? joint.driven(targets[at(joint.driver)]) : targets[j]);
  }
}

void MujocoRobot::setStiffness(int joint, double stiffness) {
  drives.at(at(joint)).setStiffness(std::clamp(stiffness, 0.0, 1.0));
}

void MujocoRobot::push(const Vec3& force, double seconds, int link) {
  static_cast<void>(robot.links.at(at(link)));
  pushForce = force;
  pushLink = link;
  pushSteps = std::lround(seconds / h);
}

ServoDrive::Side MujocoRobot::motorSide(std::size_t joint) const {
  const World::Address& a = world->joint(joint);
  return {world->data()->qpos[a.rotorPosition], world->data()->qvel[a.rotorVelocity]};
}

ServoDrive::Side MujocoRobot::linkSide(std::size_t joint) const {
  const World::Address& a = world->joint(joint);
  return {world->data()->qpos[a.position], world->data()->qvel[a.velocity]};
}

double MujocoRobot::encoder(int joint) const {
  return drives.at(at(joint)).measured(motorSide(at(joint)), linkSide(at(joint)));
}

double MujocoRobot::encoderSpeed(int joint) const {
  return (drives.at(at(joint)).drive().linkEncoder ? linkSide(at(joint)) : motorSide(at(joint))).speed;
}

/// From motor to link: a spring and a damper, with play only at its ends.
double MujocoRobot::gearTorque(std::size_t joint) const {
  const JointPlant& plant = drives[joint].drive();
  const ServoDrive::Side motor = motorSide(joint), link = linkSide(joint);
  const double apart = motor.position - link.position;
  const double beyond = apart - std::clamp(apart, -plant.backlash / 2, plant.backlash / 2);
  if (plant.backlash > 0 && beyond == 0) return 0;
  const double rotor = std::max(leastRotor, plant.servo.armature);
  const double damping =
      (plant.compliance > 0 ? 0.1 : 2 * plant.toothDamping) * std::sqrt(stiffGear[joint] * rotor);
  const double torque = stiffGear[joint] * beyond + damping * (motor.speed - link.speed);
  // Flanks push and never pull.
  return plant.backlash > 0 && torque * beyond < 0 ? 0 : torque;
}

void MujocoRobot::drive(std::size_t joint) {
  mjModel* m = world->model();
  mjData* d = world->data();
  ServoDrive& servo = drives[joint];
  const World::Address& a = world->joint(joint);
  const ServoDrive::Side motor = motorSide(joint);
  servo.begin(h, motor, linkSide(joint));
  for (int regime = 0; regime < 4 && servo.limitAt(motor.speed);) ++regime;
  d->qfrc_applied[a.rotorVelocity] += servo.offset();
  // The engine solves the damping with the step.
  m->dof_damping[a.rotorVelocity] = servo.slope() + servo.drive().viscous;
  double load = loads[joint] + servo.drive().biasForce;
  const ServoDrive::Side link = linkSide(joint);
  for (const JointTorque& torque : servo.drive().torques) load += torque(link.position, link.speed);
  d->qfrc_applied[a.velocity] += load;
  if (servo.drive().geared()) {
    const double torque = gearTorque(joint);
    d->qfrc_applied[a.rotorVelocity] -= torque;
    d->qfrc_applied[a.velocity] += torque;
  }
  if (!servo.drive().rubs()) return;
  // The engine knows one limit for both ways: what differs is a torque that pushes towards the easier one.
  const DryFriction dry = servo.dryLimit();
  m->dof_frictionloss[a.rotorVelocity] = std::max(noFriction, (dry.forward + dry.backward) / 2);
  d->qfrc_applied[a.rotorVelocity] += (dry.backward - dry.forward) / 2;
}

void MujocoRobot::pressGround() {
  for (SoftGround::Corner& corner : ground->corners()) {
    const auto link = static_cast<std::size_t>(corner.link);
    const Vec3 place = world->pose(link) * corner.local;
    ground->update(corner, place, world->velocity(link, place));
    const double none[3] = {0, 0, 0};
    if (corner.normal > 0)
      mj_applyFT(world->model(), world->data(), corner.force.data(), none, place.data(), world->body(link),
                 world->data()->qfrc_applied);
  }
}

/// What dry friction does at a degree of freedom [N m].
double MujocoRobot::dryFriction(int velocity) const {
  const mjData* d = world->data();
  for (int row = d->ne; row < d->ne + d->nf; ++row)
    if (d->efc_type[row] == mjCNSTR_FRICTION_DOF && d->efc_id[row] == velocity) return d->efc_force[row];
  return 0;
}

void MujocoRobot::substep() {
  mjModel* m = world->model();
  mjData* d = world->data();
  std::fill(d->qfrc_applied, d->qfrc_applied + m->nv, 0.0);
  double* force = d->xfrc_applied + 6 * world->body(at(pushLink));
  std::fill(force, force + 6, 0.0);
  if (pushSteps > 0) {
    --pushSteps;
    std::copy(pushForce.data(), pushForce.data() + 3, force);
  }
  for (std::size_t j = 0; j < drives.size(); ++j) drive(j);
  if (ground) pressGround();
  mj_step(m, d);
  if ((m->nv > 0 && !std::isfinite(d->qacc[0])) || d->warning[mjWARN_BADQACC].number > 0)
    throw std::runtime_error("mujoco: the simulation of " + robot.name +
                             " broke down; give it shorter steps");
  double torques = 0;
  for (std::size_t j = 0; j < drives.size(); ++j) {
    const double speed = motorSide(j).speed;
    double friction = 0;
    if (drives[j].drive().rubs()) {
      const DryFriction dry = drives[j].dryLimit();
      friction = dryFriction(world->joint(j).rotorVelocity) + (dry.backward - dry.forward) / 2;
    }
    drives[j].end(speed, friction);
    torqueSum[j] += drives[j].torque(speed);
    torques += std::abs(drives[j].torque(speed));
  }
  if (!supply.sags()) return;
  supply.take(torques, h);
  for (ServoDrive& servo : drives) servo.setSupply(supply.left(servo.drive()));
}

void MujocoRobot::step() {
  const Vec3 before = imuVelocity;
  std::fill(torqueSum.begin(), torqueSum.end(), 0.0);
  for (int i = 0; i < stepsPerCycle; ++i) substep();
  ++cycles;
  // Poses and velocities of the links are of the step's begin until they are asked for.
  mj_kinematics(world->model(), world->data());
  mj_comPos(world->model(), world->data());
  mj_comVel(world->model(), world->data());
  update();
  const Mat3 toSensor = (link(robot.imu.link).pose.linear() * rotationOfRpy(robot.imu.rpy)).transpose();
  const Vec3 acc = toSensor * ((imuVelocity - before) * robot.controlHz - robot.gravity);
  sense();
  sensed.acc = acc;
}

/// States of the links, and the accelerometer's velocity.
void MujocoRobot::update() {
  states.resize(robot.links.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    BodyState& state = states[i];
    state.pose = world->pose(i);
    state.angularVelocity = Eigen::Map<const Vec3>(world->data()->cvel + 6 * world->body(i));
    state.linearVelocity = world->velocity(i, state.pose.translation());
  }
  const BodyState& carrier = link(robot.imu.link);
  imuVelocity =
      carrier.linearVelocity + carrier.angularVelocity.cross(carrier.pose.linear() * robot.imu.accelerometer);
}

void MujocoRobot::sense() {
  sensed.time = static_cast<double>(cycles) * stepsPerCycle * h;
  sensed.position.resize(drives.size());
  sensed.velocity.resize(drives.size());
  sensed.torque.resize(drives.size());
  for (std::size_t j = 0; j < drives.size(); ++j) {
    sensed.position[j] = linkSide(j).position;
    sensed.velocity[j] = linkSide(j).speed;
    sensed.torque[j] = torqueSum[j] / stepsPerCycle;
  }
  const BodyState& carrier = link(robot.imu.link);
  sensed.gyro = (carrier.pose.linear() * rotationOfRpy(robot.imu.rpy)).transpose() * carrier.angularVelocity;
  sensed.footForce.clear();
  for (std::size_t f = 0; f < robot.feet.size(); ++f) sensed.footForce.push_back(footForces(f));
}

std::vector<double> MujocoRobot::footForces(std::size_t index) const {
  const Mechanism::Foot& foot = robot.feet[index];
  World::FootForce force;
  if (ground) {
    const Mat3 toFoot = link(foot.link).pose.linear().transpose();
    for (const SoftGround::Corner& corner : ground->corners()) {
      if (corner.foot != static_cast<int>(index)) continue;
      const double normal = (toFoot * corner.force).z();
      force.normal += normal;
      force.moment += normal * corner.local.head<2>();
    }
  } else if (!options.fixedBase) {
    force = world->footForce(foot.name, at(foot.link));
  }
  const Vec2 centre = force.normal > 0 ? Vec2(force.moment / force.normal) : Vec2(Vec2::Zero());
  return footSensorForces(foot, force.normal, centre);
}

}  // namespace plumbline::simulation::mujoco
