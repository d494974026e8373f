#include "bench/walking/MujocoPlant.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/mujoco/ModelText.h"
#include "bench/mujoco/World.h"

namespace plumbline::bench {
namespace {

constexpr double stepSeconds = 0.001;
constexpr double encoderStep = 2 * 3.14159265358979323846 / 4096, encoderNoise = 3e-4;  // [rad]
constexpr double gyroNoise = 0.005, accNoise = 0.06, forceNoise = 0.15;                 // [rad/s, m/s^2, N]

reality::ModelOptions optionsOf(const Mechanism& robot) {
  reality::ModelOptions options;
  options.freeBase = true;
  options.step = stepSeconds;
  options.geared.assign(robot.joints.size(), false);
  options.rubs.assign(robot.joints.size(), false);
  options.damping.assign(robot.joints.size(), 0);
  for (const Mechanism::Joint& joint : robot.joints) options.armature.push_back(joint.servo.armature);
  return options;
}

/// A foot's force on its sensors: a plane over their places with the same centre of pressure, none of which
/// pulls.
std::vector<double> spread(const Mechanism::Foot& foot, double normal, const Vec2& moment) {
  std::vector<double> loads(foot.sensors.size(), 0);
  if (!(normal > 0)) return loads;
  Mat3 moments = 1e-9 * Mat3::Identity();
  for (const Mechanism::ForceSensor& sensor : foot.sensors) {
    const Vec3 m(1, sensor.position.x(), sensor.position.y());
    moments += m * m.transpose();
  }
  const Vec3 plane = moments.ldlt().solve(Vec3(normal, moment.x(), moment.y()));
  double sum = 0;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Vec3& p = foot.sensors[i].position;
    sum += loads[i] = std::max(0.0, plane.dot(Vec3(1, p.x(), p.y())));
  }
  for (double& load : loads) load *= sum > 0 ? normal / sum : 0;
  return loads;
}

}  // namespace

MujocoPlant::MujocoPlant(const Mechanism& robot_)
    : robot(robot_),
      substeps(static_cast<int>(std::lround(1 / robot.controlHz / stepSeconds))),
      world(std::make_unique<reality::World>(robot, reality::modelText(robot, optionsOf(robot)))) {}

MujocoPlant::~MujocoPlant() = default;

void MujocoPlant::restart(const std::vector<double>& posture, double heading) {
  mjData* d = world->data();
  mj_resetData(world->model(), d);
  const std::vector<Pose3> poses = linkPoses(robot, posture);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Mechanism::Foot& foot : robot.feet)
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) {
        const Vec3 corner =
            foot.soleCentre + Vec3(x * foot.soleSize.x(), y * foot.soleSize.y(), -0.5 * foot.soleSize.z());
        lowest = std::min(lowest, (poses[static_cast<std::size_t>(foot.link)] * corner).z());
      }
  const double state[7] = {0, 0, -lowest, std::cos(heading / 2), 0, 0, std::sin(heading / 2)};
  std::copy(std::begin(state), std::end(state), d->qpos);
  for (std::size_t j = 0; j < posture.size(); ++j) d->qpos[world->joint(j).position] = posture[j];
  valid.target = posture;
  valid.stiffness.assign(posture.size(), 1);
  mj_forward(world->model(), d);
  random = Random(1);
  gyro.setZero();
  acc = Vec3(0, 0, 9.81);
  sense();
}

void MujocoPlant::push(const Vec3& force) {
  std::copy(force.data(), force.data() + 3, world->data()->xfrc_applied + 6 * world->body(0));
}

void MujocoPlant::actuate() {
  mjData* d = world->data();
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Mechanism::Joint& joint = robot.joints[j];
    const std::size_t motor = joint.driver >= 0 ? static_cast<std::size_t>(joint.driver) : j;
    const double target =
        joint.driver >= 0 ? joint.driverRatio * valid.target[motor] + joint.driverOffset : valid.target[j];
    const double stiffness = valid.stiffness[motor];
    const reality::World::Address& a = world->joint(j);
    const double q = d->qpos[a.position], v = d->qvel[a.velocity];
    double torque = stiffness * (joint.servo.kp * (target - q) - joint.servo.kd * v);
    double most = stiffness * joint.maxTorque;
    if (torque * v > 0) most *= std::clamp((joint.maxSpeed - std::abs(v)) / (0.1 * joint.maxSpeed), 0.0, 1.0);
    d->qfrc_applied[a.velocity] = std::clamp(torque, -most, most);
  }
}

void MujocoPlant::step() {
  mjData* d = world->data();
  gyro.setZero();
  acc.setZero();
  for (int i = 0; i < substeps; ++i) {
    actuate();
    mj_step(world->model(), d);
    acc += Eigen::Map<const Vec3>(d->sensordata + 3) / substeps;
  }
  gyro = Eigen::Map<const Vec3>(d->sensordata);
  push(Vec3::Zero());
  sense();
}

void MujocoPlant::sense() {
  const mjData* d = world->data();
  measured.position.resize(robot.joints.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    measured.position[j] = encoderStep * std::round(d->qpos[world->joint(j).position] / encoderStep) +
                           encoderNoise * random.gaussian();
  for (int a = 0; a < 3; ++a) {
    measured.gyro[a] = gyro[a] + gyroNoise * random.gaussian();
    measured.acc[a] = acc[a] + accNoise * random.gaussian();
  }
  measured.footForce.clear();
  for (const Mechanism::Foot& foot : robot.feet) {
    const reality::World::FootForce force = world->footForce(foot.name, static_cast<std::size_t>(foot.link));
    std::vector<double> loads = spread(foot, force.normal, force.moment);
    for (double& load : loads) load = std::max(0.0, load + forceNoise * random.gaussian());
    measured.footForce.push_back(loads);
  }
}

Pose3 MujocoPlant::torso() const {
  const double* q = world->data()->qpos;
  Pose3 T = translation(q[0], q[1], q[2]);
  T.linear() = Eigen::Quaterniond(q[3], q[4], q[5], q[6]).toRotationMatrix();
  return T;
}

Vec3 MujocoPlant::comVelocity() const {
  mj_subtreeVel(world->model(), world->data());
  return Eigen::Map<const Vec3>(world->data()->subtree_linvel + 3 * world->body(0));
}

}  // namespace plumbline::bench
