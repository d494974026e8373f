#include "Reality.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "Drive.h"
#include "math/Random.h"
#include "servo/mujoco/MujocoModel.h"
#include "servo/mujoco/MujocoWorld.h"
#include "servo/mujoco/SoftGround.h"
#include "simulation/league/MakeWorld.h"

namespace plumbline::reality {
namespace {

using gap::ChannelKind;
using servo::mujoco::ModelOptions;
using servo::mujoco::modelText;
using servo::mujoco::SoftGround;
using servo::mujoco::World;

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
  Recorder(const Mechanism& nominal, const std::vector<RealityEffect>& effects, const RealityOptions& options,
           const gap::Excitation& program, std::uint64_t seed)
      : nominal_(nominal),
        effects_(effects),
        options_(options),
        program_(program),
        robot_(changedBody(nominal, effects)),
        random_(seed),
        dropRandom_(seed ^ 0x9e3779b97f4a7c15ULL),
        R_ground_(turnedBy(rotationVector(effects, "ground_slope"))) {
    for (int j = 0; j < robot_.numJoints(); ++j) drives_.emplace_back(nominal_, j, effects_, options_.step);
    makeWorld();
    // Cycles are whole steps, so that their times are what stands in the run.
    perCycle_ = std::max<long>(1, std::lround(1 / (nominal_.controlHz * options_.step)));
    rate_ = 1 / (static_cast<double>(perCycle_) * options_.step);
    table_ = gap::playExcitation(program_, nominal_, rate_);
    prepareRun();
  }

  gap::Run record() {
    const long settle = std::lround((program_.freeBase ? 2.0 : 1.0) / options_.step);
    const long end = perCycle_ * static_cast<long>(table_.t.size() - 1);
    const double dropout = valueOf(effects_, "command_dropout", 0);
    place();
    for (long k = -settle; k <= end; ++k) {
      const double t = static_cast<double>(k) * options_.step;
      if (k >= 0 && k % perCycle_ == 0) {
        const auto cycle = static_cast<std::size_t>(k / perCycle_);
        read(t, cycle);
        const bool lost = dropout > 0 && dropRandom_.uniform() < dropout;
        for (std::size_t j = 0; j < drives_.size() && !lost; ++j)
          drives_[j].command(t, table_.commands[j][cycle]);
        if (!lost) sent_ = cycle;
      }
      step(t);
    }
    return std::move(run_);
  }

private:
  void makeWorld() {
    ModelOptions model;
    model.freeBase = program_.freeBase;
    model.step = options_.step;
    model.groundFriction = valueOf(effects_, "ground_friction", 0.8);
    model.slope = rotationVector(effects_, "ground_slope");
    const bool soft = program_.freeBase && has(effects_, "ground_compliance");
    model.engineContacts = !soft;
    for (std::size_t j = 0; j < drives_.size(); ++j) {
      model.geared.push_back(drives_[j].isGeared());
      model.armature.push_back(drives_[j].rotorInertia());
      model.damping.push_back(drives_[j].viscousFriction());
      model.hasFriction.push_back(drives_[j].hasDryFriction());
    }
    world_ = std::make_unique<World>(robot_, modelText(robot_, model));
    if (soft)
      ground_ = std::make_unique<SoftGround>(robot_, valueOf(effects_, "ground_compliance", 0),
                                             model.groundFriction, R_ground_);
    transmitted_.assign(drives_.size(), 0);
  }

  /// First posture, and a free robot on its soles on the ground, turned as the program says.
  void place() {
    mjData* d = world_->data();
    std::vector<double> q;
    for (std::size_t j = 0; j < drives_.size(); ++j) {
      q.push_back(table_.commands[j][0]);
      drives_[j].start(q[j]);
      d->qpos[world_->joint(j).position] = d->qpos[world_->joint(j).rotorPosition] = q[j];
    }
    if (program_.freeBase && !robot_.feet.empty()) {
      const std::vector<Pose3> poses = linkPoses(robot_, q);
      // Put down with the torso level with the ground, as a person does: soles that are not level rock.
      const Mat3 R = R_ground_ * rotationZ(program_.heading).linear();
      double lowest = 1e9;
      for (const Mechanism::Foot& foot : robot_.feet)
        for (const double x : {-0.5, 0.5})
          for (const double y : {-0.5, 0.5}) {
            const Vec3 corner = foot.soleCentre +
                                Vec3(x * foot.soleSize.x(), y * foot.soleSize.y(), -0.5 * foot.soleSize.z());
            lowest = std::min(
                lowest, R_ground_.col(2).dot(R * (poses[static_cast<std::size_t>(foot.link)] * corner)));
          }
      const Vec3 place = -lowest * R_ground_.col(2);
      const Eigen::Quaterniond turn(R);
      const double state[7] = {place.x(), place.y(), place.z(), turn.w(), turn.x(), turn.y(), turn.z()};
      std::copy(std::begin(state), std::end(state), d->qpos);
    }
    for (const RealityEffect& e : effects_) {
      if (e.effect != "external_force") continue;
      const int body = world_->body(static_cast<std::size_t>(robot_.linkIndex(e.at)));
      const Vec3 force = e.value * axisVector(e.axis);
      for (int a = 0; a < 3; ++a) d->xfrc_applied[6 * body + a] += force[a];
    }
    mj_forward(world_->model(), d);
    for (std::size_t j = 0; j < drives_.size(); ++j)
      drives_[j].carries(d->qM[world_->model()->dof_Madr[world_->joint(j).velocity]]);
  }

  void step(double t) {
    mjModel* m = world_->model();
    mjData* d = world_->data();
    std::fill(d->qfrc_applied, d->qfrc_applied + m->nv, 0.0);
    double torques = 0, most = 0;
    for (std::size_t j = 0; j < drives_.size(); ++j) {
      const World::Address& a = world_->joint(j);
      const double rubbed = drives_[j].hasDryFriction() ? rubbedAt(a.rotorVelocity) : 0;
      const Drive::Torques torque =
          drives_[j].update(t, d->qpos[a.rotorPosition], d->qvel[a.rotorVelocity], d->qpos[a.position],
                            d->qvel[a.velocity], transmitted_[j], rubbed, neighbourOf(j));
      torques += std::abs(torque.motor);
      most += drives_[j].maxTorque();
      d->qfrc_applied[a.rotorVelocity] += torque.motor;
      d->qfrc_applied[a.velocity] += torque.link;
      if (drives_[j].isGeared()) {
        d->qfrc_applied[a.rotorVelocity] -= torque.gear;
        d->qfrc_applied[a.velocity] += torque.gear;
        transmitted_[j] = torque.gear;
      } else {
        transmitted_[j] = torque.motor - drives_[j].rotorInertia() * d->qacc[a.velocity];
      }
      if (drives_[j].hasDryFriction()) m->dof_frictionloss[a.rotorVelocity] = std::max(1e-9, torque.friction);
    }
    // The line's capacitors follow within 10 ms.
    supplyLoad_ += std::min(1.0, options_.step / 0.01) * (torques / most - supplyLoad_);
    for (Drive& drive : drives_) drive.supplyLoad(supplyLoad_);
    if (ground_) {
      for (SoftGround::Corner& corner : ground_->corners()) {
        const auto link = static_cast<std::size_t>(corner.link);
        const Vec3 at = world_->pose(link) * corner.local;
        ground_->update(corner, at, world_->velocity(link, at));
        const double none[3] = {0, 0, 0};
        if (corner.normal > 0)
          mj_applyFT(m, d, corner.force.data(), none, at.data(), world_->body(link), d->qfrc_applied);
      }
    }
    mj_step(m, d);
    if (!std::isfinite(d->qacc[0]) || d->warning[mjWARN_BADQACC].number > 0)
      throw std::runtime_error("the simulation of " + program_.name + " broke down at " + std::to_string(t) +
                               " s");
    if (nominal_.hasImu) {
      imu_.push_back({t,
                      {Vec3(d->sensordata[0], d->sensordata[1], d->sensordata[2]),
                       Vec3(d->sensordata[3], d->sensordata[4], d->sensordata[5])}});
      const double late = valueOf(effects_, "imu_delay", 0);
      while (imu_.size() > 1 && imu_[1].first <= t - late + 1e-9) imu_.pop_front();
    }
  }

  /// What dry friction did at a degree of freedom in the last step [N m].
  double rubbedAt(int dof) {
    const mjData* d = world_->data();
    for (int row = 0; row < d->nefc; ++row)
      if (d->efc_type[row] == mjCNSTR_FRICTION_DOF && d->efc_id[row] == dof) return d->efc_force[row];
    return 0;
  }

  /// How far the command of the joint before (or after, at the base) is from its start.
  double neighbourOf(std::size_t j) const {
    const int parent = nominal_.joints[j].parent;
    const std::size_t other =
        parent > 0 ? static_cast<std::size_t>(parent) - 1 : std::min(j + 1, drives_.size() - 1);
    return table_.commands[other][sent_] - table_.commands[other][0];
  }

  void prepareRun() {
    run_.robot = nominal_.name;
    run_.freeBase = program_.freeBase;
    run_.rateHz = rate_;
    run_.motion = program_.about;
    run_.groundTruth = options_.truth;
    if (program_.freeBase) run_.heading = program_.heading;
  }

  void add(const std::string& channel, double x) { run_.channels[channel].push_back(x); }
  double noise(double deviation) { return options_.noise ? deviation * random_.gaussian() : 0; }

  void read(double t, std::size_t cycle) {
    const mjData* d = world_->data();
    run_.t.push_back(t);
    for (std::size_t j = 0; j < drives_.size(); ++j) {
      const World::Address& a = world_->joint(j);
      const std::string& name = nominal_.joints[j].name;
      add("cmd." + name, table_.commands[j][cycle]);
      double q = drives_[j].encoder(d->qpos[a.rotorPosition], d->qpos[a.position]);
      if (options_.noise)
        q = options_.encoderStep * std::round(q / options_.encoderStep) + noise(options_.encoderNoise);
      add("pos." + name, q);
    }
    if (nominal_.hasImu) readImu();
    if (program_.freeBase) readFeet();
    if (options_.truth) readTruth();
  }

  void readImu() {
    const Mat3 turned = turnedBy(rotationVector(effects_, "imu_misalignment"));
    auto [gyro, acc] = imu_.front().second;
    gyro = turned.transpose() * gyro;
    acc = turned.transpose() * acc;
    for (const RealityEffect& e : effects_) {
      if (e.effect == "gyro_bias") gyro += e.value * axisVector(e.axis);
      if (e.effect == "acc_bias") acc += e.value * axisVector(e.axis);
      if (e.effect == "gyro_scale") gyro += (e.value - 1) * axisVector(e.axis).cwiseProduct(gyro);
    }
    for (int a = 0; a < 3; ++a) {
      const std::string axis(1, "xyz"[a]);
      add("gyro." + axis, gyro[a] + noise(options_.gyroNoise));
      add("acc." + axis, acc[a] + noise(options_.accNoise));
    }
  }

  void readFeet() {
    for (std::size_t f = 0; f < robot_.feet.size(); ++f) {
      const Mechanism::Foot& foot = robot_.feet[f];
      World::FootForce force;
      if (ground_) {
        const Mat3 R = world_->pose(static_cast<std::size_t>(foot.link)).linear();
        for (const SoftGround::Corner& corner : ground_->corners()) {
          if (corner.foot != static_cast<int>(f)) continue;
          const double normal = (R.transpose() * corner.force).z();
          force.normal += normal;
          force.moment += normal * corner.local.head<2>();
        }
      } else {
        force = world_->footForce(foot.name, static_cast<std::size_t>(foot.link));
      }
      double gain = 1;
      for (const RealityEffect& e : effects_)
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
          std::max(0.0, gain * load + noise(options_.forceNoise)));
    }
  }

  void readTruth() {
    const Pose3 T = world_->pose(0);
    const Eigen::Quaterniond q(T.linear());
    add("truth.x", T.translation().x());
    add("truth.y", T.translation().y());
    add("truth.z", T.translation().z());
    add("truth.qw", q.w());
    add("truth.qx", q.x());
    add("truth.qy", q.y());
    add("truth.qz", q.z());
  }

  const Mechanism& nominal_;
  const std::vector<RealityEffect>& effects_;
  const RealityOptions& options_;
  const gap::Excitation& program_;
  const Mechanism robot_;  ///< with its body changed
  Random random_, dropRandom_;
  const Mat3 R_ground_;
  std::vector<Drive> drives_;
  std::unique_ptr<World> world_;
  std::unique_ptr<SoftGround> ground_;
  gap::CommandTable table_;
  long perCycle_ = 1;
  double rate_ = 100;
  std::vector<double> transmitted_;
  double supplyLoad_ = 0;  ///< share of the largest torques of all motors
  std::deque<std::pair<double, std::pair<Vec3, Vec3>>> imu_;
  std::size_t sent_ = 0;
  gap::Run run_;
};

}  // namespace

Reality::Reality(const Mechanism& robot, std::vector<RealityEffect> effects, RealityOptions options)
    : robot_(robot), effects_(std::move(effects)), options_(options) {
  for (const RealityEffect& effect : effects_) checkEffect(effect, robot_);
}

gap::Run Reality::record(const gap::Excitation& program, std::uint64_t seed) const {
  return Recorder(robot_, effects_, options_, program, seed).record();
}

}  // namespace plumbline::reality
