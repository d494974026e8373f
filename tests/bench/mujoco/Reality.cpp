#include "Reality.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "Drive.h"
#include "math/Random.h"
#include "simulation/league/MakeWorld.h"
#include "simulation/servo/mujoco/MujocoModel.h"
#include "simulation/servo/mujoco/MujocoWorld.h"
#include "simulation/servo/mujoco/SoftGround.h"

namespace plumbline::reality {
namespace {

using gap::ChannelKind;
using simulation::mujoco::ModelOptions;
using simulation::mujoco::modelText;
using simulation::mujoco::SoftGround;
using simulation::mujoco::World;

double valueOf(const std::vector<RealityEffect>& effects, const char* id, double nominal) {
  for (const RealityEffect& e : effects)
    if (e.effect == id) return e.value;
  return nominal;
}

bool has(const std::vector<RealityEffect>& effects, const char* id) {
  return std::any_of(effects.begin(), effects.end(), [&](const RealityEffect& e) { return e.effect == id; });
}

Vec3 rotationVector(const std::vector<RealityEffect>& effects, const char* id) {
  Vec3 sum = Vec3::Zero();
  for (const RealityEffect& e : effects)
    if (e.effect == id) sum += e.value * axisVector(e.axis);
  return sum;
}

Mat3 turnedBy(const Vec3& v) {
  return v.norm() > 0 ? Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix()
                      : Mat3(Mat3::Identity());
}

/// One run in the making.
class Recorder {
public:
  Recorder(const Mechanism& nominal_, const std::vector<RealityEffect>& effects_,
           const RealityOptions& options_, const gap::Excitation& program_, std::uint64_t seed)
      : nominal(nominal_),
        effects(effects_),
        options(options_),
        program(program_),
        robot(changedBody(nominal_, effects_)),
        random(seed),
        dropRandom(seed ^ 0x9e3779b97f4a7c15ULL),
        R_ground(turnedBy(rotationVector(effects_, "ground_slope"))) {
    for (int j = 0; j < robot.numJoints(); ++j) drives.emplace_back(nominal, j, effects, options.step);
    makeWorld();
    // Cycles are whole steps, so that their times are what stands in the run.
    perCycle = std::max<long>(1, std::lround(1 / (nominal.controlHz * options.step)));
    rate = 1 / (static_cast<double>(perCycle) * options.step);
    table = gap::playExcitation(program, nominal, rate);
    prepareRun();
  }

  gap::Run record() {
    const long settle = std::lround((program.freeBase ? 2.0 : 1.0) / options.step);
    const long end = perCycle * static_cast<long>(table.t.size() - 1);
    const double dropout = valueOf(effects, "command_dropout", 0);
    place();
    for (long k = -settle; k <= end; ++k) {
      const double t = static_cast<double>(k) * options.step;
      if (k >= 0 && k % perCycle == 0) {
        const auto cycle = static_cast<std::size_t>(k / perCycle);
        read(t, cycle);
        const bool lost = dropout > 0 && dropRandom.uniform() < dropout;
        for (std::size_t j = 0; j < drives.size() && !lost; ++j)
          drives[j].command(t, table.commands[j][cycle]);
        if (!lost) sent = cycle;
      }
      step(t);
    }
    return std::move(run);
  }

private:
  void makeWorld() {
    ModelOptions model;
    model.freeBase = program.freeBase;
    model.step = options.step;
    model.groundFriction = valueOf(effects, "ground_friction", 0.8);
    model.slope = rotationVector(effects, "ground_slope");
    const bool soft = program.freeBase && has(effects, "ground_compliance");
    model.engineContacts = !soft;
    for (std::size_t j = 0; j < drives.size(); ++j) {
      model.geared.push_back(drives[j].isGeared());
      model.armature.push_back(drives[j].rotorInertia());
      model.damping.push_back(drives[j].viscousFriction());
      model.rubs.push_back(std::any_of(effects.begin(), effects.end(), [&](const RealityEffect& e) {
        const bool dry =
            e.effect == "coulomb_friction" || e.effect == "stribeck_friction" || e.effect == "load_friction";
        const std::vector<int> at = jointsOf(e, nominal);
        return dry && std::find(at.begin(), at.end(), static_cast<int>(j)) != at.end();
      }));
    }
    rubs = model.rubs;
    world = std::make_unique<World>(robot, modelText(robot, model));
    if (soft)
      ground = std::make_unique<SoftGround>(robot, valueOf(effects, "ground_compliance", 0),
                                            model.groundFriction, R_ground);
    transmitted.assign(drives.size(), 0);
  }

  /// First posture, and a free robot on its soles on the ground, turned as the program says.
  void place() {
    mjData* d = world->data();
    std::vector<double> q;
    for (std::size_t j = 0; j < drives.size(); ++j) {
      q.push_back(table.commands[j][0]);
      drives[j].start(q[j]);
      d->qpos[world->joint(j).position] = d->qpos[world->joint(j).rotorPosition] = q[j];
    }
    if (program.freeBase && !robot.feet.empty()) {
      const std::vector<Pose3> poses = linkPoses(robot, q);
      // Put down with the torso level with the ground, as a person does: soles that are not level rock.
      const Mat3 R = R_ground * rotationZ(program.heading).linear();
      double lowest = 1e9;
      for (const Mechanism::Foot& foot : robot.feet)
        for (const double x : {-0.5, 0.5})
          for (const double y : {-0.5, 0.5}) {
            const Vec3 corner = foot.soleCentre +
                                Vec3(x * foot.soleSize.x(), y * foot.soleSize.y(), -0.5 * foot.soleSize.z());
            lowest = std::min(lowest,
                              R_ground.col(2).dot(R * (poses[static_cast<std::size_t>(foot.link)] * corner)));
          }
      const Vec3 place = -lowest * R_ground.col(2);
      const Eigen::Quaterniond turn(R);
      const double state[7] = {place.x(), place.y(), place.z(), turn.w(), turn.x(), turn.y(), turn.z()};
      std::copy(std::begin(state), std::end(state), d->qpos);
    }
    for (const RealityEffect& e : effects) {
      if (e.effect != "external_force") continue;
      const int body = world->body(static_cast<std::size_t>(robot.linkIndex(e.at)));
      const Vec3 force = e.value * axisVector(e.axis);
      for (int a = 0; a < 3; ++a) d->xfrc_applied[6 * body + a] += force[a];
    }
    mj_forward(world->model(), d);
    for (std::size_t j = 0; j < drives.size(); ++j)
      drives[j].carries(d->qM[world->model()->dof_Madr[world->joint(j).velocity]]);
  }

  void step(double t) {
    mjModel* m = world->model();
    mjData* d = world->data();
    std::fill(d->qfrc_applied, d->qfrc_applied + m->nv, 0.0);
    for (std::size_t j = 0; j < drives.size(); ++j) {
      const World::Address& a = world->joint(j);
      const Drive::Torques torque =
          drives[j].update(t, d->qpos[a.rotorPosition], d->qvel[a.rotorVelocity], d->qpos[a.position],
                           d->qvel[a.velocity], transmitted[j], neighbourOf(j));
      d->qfrc_applied[a.rotorVelocity] += torque.motor;
      d->qfrc_applied[a.velocity] += torque.link;
      if (drives[j].isGeared()) {
        d->qfrc_applied[a.rotorVelocity] -= torque.gear;
        d->qfrc_applied[a.velocity] += torque.gear;
        transmitted[j] = torque.gear;
      } else {
        transmitted[j] = torque.motor - drives[j].rotorInertia() * d->qacc[a.velocity];
      }
      if (rubs[j]) m->dof_frictionloss[a.rotorVelocity] = std::max(1e-9, torque.friction);
    }
    if (ground) {
      for (SoftGround::Corner& corner : ground->corners()) {
        const auto link = static_cast<std::size_t>(corner.link);
        const Vec3 at = world->pose(link) * corner.local;
        ground->update(corner, at, world->velocity(link, at));
        const double none[3] = {0, 0, 0};
        if (corner.normal > 0)
          mj_applyFT(m, d, corner.force.data(), none, at.data(), world->body(link), d->qfrc_applied);
      }
    }
    mj_step(m, d);
    if (!std::isfinite(d->qacc[0]) || d->warning[mjWARN_BADQACC].number > 0)
      throw std::runtime_error("the simulation of " + program.name + " broke down at " + std::to_string(t) +
                               " s");
    if (nominal.hasImu) {
      imu.push_back({t,
                     {Vec3(d->sensordata[0], d->sensordata[1], d->sensordata[2]),
                      Vec3(d->sensordata[3], d->sensordata[4], d->sensordata[5])}});
      const double late = valueOf(effects, "imu_delay", 0);
      while (imu.size() > 1 && imu[1].first <= t - late + 1e-9) imu.pop_front();
    }
  }

  /// How far the command of the joint before (or after, at the base) is from its start.
  double neighbourOf(std::size_t j) const {
    const int parent = nominal.joints[j].parent;
    const std::size_t other =
        parent > 0 ? static_cast<std::size_t>(parent) - 1 : std::min(j + 1, drives.size() - 1);
    return table.commands[other][sent] - table.commands[other][0];
  }

  void prepareRun() {
    run.robot = nominal.name;
    run.freeBase = program.freeBase;
    run.rateHz = rate;
    run.motion = program.about;
    run.groundTruth = options.truth;
    if (program.freeBase) run.heading = program.heading;
  }

  void add(const std::string& channel, double x) { run.channels[channel].push_back(x); }
  double noise(double deviation) { return options.noise ? deviation * random.gaussian() : 0; }

  void read(double t, std::size_t cycle) {
    const mjData* d = world->data();
    run.t.push_back(t);
    for (std::size_t j = 0; j < drives.size(); ++j) {
      const World::Address& a = world->joint(j);
      const std::string& name = nominal.joints[j].name;
      add("cmd." + name, table.commands[j][cycle]);
      double q = drives[j].encoder(d->qpos[a.rotorPosition], d->qpos[a.position]);
      if (options.noise)
        q = options.encoderStep * std::round(q / options.encoderStep) + noise(options.encoderNoise);
      add("pos." + name, q);
    }
    if (nominal.hasImu) readImu();
    if (program.freeBase) readFeet();
    if (options.truth) readTruth();
  }

  void readImu() {
    const Mat3 turned = turnedBy(rotationVector(effects, "imu_misalignment"));
    auto [gyro, acc] = imu.front().second;
    gyro = turned.transpose() * gyro;
    acc = turned.transpose() * acc;
    for (const RealityEffect& e : effects) {
      if (e.effect == "gyro_bias") gyro += e.value * axisVector(e.axis);
      if (e.effect == "acc_bias") acc += e.value * axisVector(e.axis);
      if (e.effect == "gyro_scale") gyro += (e.value - 1) * axisVector(e.axis).cwiseProduct(gyro);
    }
    for (int a = 0; a < 3; ++a) {
      const std::string axis(1, "xyz"[a]);
      add("gyro." + axis, gyro[a] + noise(options.gyroNoise));
      add("acc." + axis, acc[a] + noise(options.accNoise));
    }
  }

  void readFeet() {
    for (std::size_t f = 0; f < robot.feet.size(); ++f) {
      const Mechanism::Foot& foot = robot.feet[f];
      World::FootForce force;
      if (ground) {
        const Mat3 R = world->pose(static_cast<std::size_t>(foot.link)).linear();
        for (const SoftGround::Corner& corner : ground->corners()) {
          if (corner.foot != static_cast<int>(f)) continue;
          const double normal = (R.transpose() * corner.force).z();
          force.normal += normal;
          force.moment += normal * corner.local.head<2>();
        }
      } else {
        force = world->footForce(foot.name, static_cast<std::size_t>(foot.link));
      }
      double gain = 1;
      for (const RealityEffect& e : effects)
        if (e.effect == "fsr_gain" && e.at == foot.name) gain *= e.value;
      spread(foot, force, gain);
    }
  }

  /// A rigid plate on equal springs at the sensors, which push and never pull: a force is a plane over their
  /// places where that is above 0. Newton's method; beyond the sensors' outline there is no such plane, and
  /// the nearest sensors carry all.
  void spread(const Mechanism::Foot& foot, const World::FootForce& force, double gain) {
    if (foot.sensors.empty()) return;
    constexpr double metre = 0.05;  // scales the places
    const Vec3 wanted(force.normal, force.moment.x() / metre, force.moment.y() / metre);
    const auto row = [&](const Mechanism::ForceSensor& s) {
      return Vec3(1, s.position.x() / metre, s.position.y() / metre);
    };
    Vec3 plane = Vec3(force.normal / static_cast<double>(foot.sensors.size()), 0, 0);
    for (int i = 0; i < 60 && force.normal > 0; ++i) {
      Vec3 missing = wanted - 1e-4 * plane;
      Mat3 slope = 1e-4 * Mat3::Identity();
      for (const Mechanism::ForceSensor& sensor : foot.sensors) {
        const Vec3 r = row(sensor);
        const double load = plane.dot(r);
        if (load <= 0) continue;
        missing -= load * r;
        slope += r * r.transpose();
      }
      if (missing.norm() < 1e-6) break;
      plane += (i < 8 ? 1.0 : 0.5) * slope.ldlt().solve(missing);
    }
    double sum = 0;
    std::vector<double> loads;
    for (const Mechanism::ForceSensor& sensor : foot.sensors) {
      loads.push_back(force.normal > 0 ? std::max(0.0, plane.dot(row(sensor))) : 0);
      sum += loads.back();
    }
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const double load = sum > 0 ? loads[i] * std::max(0.0, force.normal) / sum : 0;
      add("fsr." + foot.name + "." + foot.sensors[i].corner,
          std::max(0.0, gain * load + noise(options.forceNoise)));
    }
  }

  void readTruth() {
    const Pose3 T = world->pose(0);
    const Eigen::Quaterniond q(T.linear());
    add("truth.x", T.translation().x());
    add("truth.y", T.translation().y());
    add("truth.z", T.translation().z());
    add("truth.qw", q.w());
    add("truth.qx", q.x());
    add("truth.qy", q.y());
    add("truth.qz", q.z());
  }

  const Mechanism& nominal;
  const std::vector<RealityEffect>& effects;
  const RealityOptions& options;
  const gap::Excitation& program;
  const Mechanism robot;  ///< with its body changed
  Random random, dropRandom;
  const Mat3 R_ground;
  std::vector<Drive> drives;
  std::vector<bool> rubs;
  std::unique_ptr<World> world;
  std::unique_ptr<SoftGround> ground;
  gap::CommandTable table;
  long perCycle = 1;
  double rate = 100;
  std::vector<double> transmitted;
  std::deque<std::pair<double, std::pair<Vec3, Vec3>>> imu;
  std::size_t sent = 0;
  gap::Run run;
};

}  // namespace

Reality::Reality(const Mechanism& robot_, std::vector<RealityEffect> effects_, RealityOptions options_)
    : robot(robot_), effects(std::move(effects_)), options(options_) {
  for (const RealityEffect& effect : effects) checkEffect(effect, robot);
}

gap::Run Reality::record(const gap::Excitation& program, std::uint64_t seed) const {
  return Recorder(robot, effects, options, program, seed).record();
}

}  // namespace plumbline::reality
