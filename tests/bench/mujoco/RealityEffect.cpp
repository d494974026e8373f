#include "RealityEffect.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace plumbline::reality {

namespace {

/// Where a link ends: at its farthest joint, or twice as far out as its centre of mass.
Vec3 endOf(const Mechanism& robot, int link) {
  Vec3 end = Vec3::Zero();
  for (const Mechanism::Joint& joint : robot.joints)
    if (joint.parent == link && joint.origin.norm() > end.norm()) end = joint.origin;
  return end.norm() > 0 ? end : Vec3(2 * robot.links[static_cast<std::size_t>(link)].com);
}

/// A point of that mass fixed to a link. The inertia of two points about their common centre of mass is that
/// of their reduced mass at their distance.
void attach(Mechanism::Link& link, double mass, const Vec3& place) {
  const Vec3 way = place - link.com;
  const double reduced = 1 / (1 / link.mass + 1 / mass);
  link.inertia += reduced * (way.dot(way) * Mat3::Identity() - way * way.transpose());
  link.com = (link.mass * link.com + mass * place) / (link.mass + mass);
  link.mass += mass;
}

}  // namespace

const std::vector<EffectKind>& effectKinds() {
  static const std::vector<EffectKind> kinds = {
      {"command_delay", "everywhere joint", false, true, "s"},
      {"command_dropout", "everywhere", false, true, "1"},
      {"servo_gain", "joint", false, true, "1"},
      {"servo_damping", "joint", false, true, "1"},
      {"torque_limit", "joint everywhere", false, true, "1"},
      {"speed_limit", "joint everywhere", false, true, "1"},
      {"coulomb_friction", "joint", false, true, "N m"},
      {"viscous_friction", "joint", false, true, "N m s/rad"},
      {"stribeck_friction", "joint", false, true, "N m"},
      {"load_friction", "joint", false, true, "1"},
      {"backlash", "joint", false, true, "rad"},
      {"joint_compliance", "joint", false, true, "rad/(N m)"},
      {"acceleration_limit", "joint", false, true, "rad/s^2"},
      {"dead_band", "joint", false, true, "rad"},
      {"supply_voltage", "everywhere", false, true, "1"},
      {"bias_force", "joint", false, true, "N m"},
      {"thermal_derating", "joint everywhere", false, true, "1/J"},
      {"rotor_inertia", "joint", false, true, "kg m^2"},
      {"joint_offset", "joint", false, true, "rad"},
      {"encoder_nonlinearity", "joint", false, true, "rad"},
      {"link_mass", "link", false, true, "kg"},
      {"com_offset", "link", true, true, "m"},
      {"link_length", "link", false, true, "1"},
      {"imu_misalignment", "imu", true, true, "rad"},
      {"gyro_bias", "imu", true, true, "rad/s"},
      {"imu_delay", "imu", false, true, "s"},
      {"fsr_gain", "foot", false, true, "1"},
      {"ground_friction", "ground", false, true, "1"},
      {"ground_slope", "ground", true, true, "rad"},
      {"ground_compliance", "ground", false, true, "m/N"},
      {"external_force", "link", true, true, "N"},
      {"asymmetric_friction", "joint", false, true, "N m"},
      {"load_stribeck_friction", "joint", false, true, "1"},
      {"quadratic_load_friction", "joint", false, true, "1/(N m)"},
      {"profile_speed", "joint", false, true, "rad/s"},
      {"payload", "link", false, true, "kg"},
      {"supply_sag", "everywhere", false, true, "1"},
      {"duty_limit", "joint", false, true, "N m"},
      {"command_lag", "joint", false, true, "s"},  // first-order lag of the command
      // Outside the library:
      {"gear_ripple", "joint", false, false, "N m"},       // torque that repeats with the gear's teeth
      {"cogging", "joint", false, false, "N m"},           // the same, finer: the motor's magnets
      {"joint_spring", "joint", false, false, "N m/rad"},  // pulls towards the first posture
      {"cable_spring", "joint", false, false, "N m/rad"},  // pulls only beyond the first posture
      {"asymmetric_damping", "joint", false, false, "N m s/rad"},  // in one direction of turning only
      {"gain_drift", "joint", false, false, "1"},                  // kp falls by this share within the run
      {"servo_integral", "joint", false, false, "1/s"},            // the servo sums its error up
      {"command_resolution", "joint", false, false, "rad"},  // step of the commands that the servo takes
      {"crosstalk", "joint", false, false, "1"},             // share of the neighbour's motion in the command
      {"bristle_friction", "joint", false, false, "N m"},    // friction that builds up over 0.02 rad
      {"gyro_scale", "imu", true, false, "1"},
      {"acc_bias", "imu", true, false, "m/s^2"},
  };
  return kinds;
}

const EffectKind* findKind(const std::string& id) {
  const auto& kinds = effectKinds();
  const auto it = std::find_if(kinds.begin(), kinds.end(), [&](const EffectKind& k) { return id == k.id; });
  return it == kinds.end() ? nullptr : &*it;
}

void checkEffect(const RealityEffect& e, const Mechanism& robot) {
  const EffectKind* kind = findKind(e.effect);
  if (!kind) throw std::runtime_error("effect " + e.effect + " is not known");
  const std::string_view sites = kind->site;
  const auto may = [&](const char* site) { return sites.find(site) != std::string_view::npos; };
  const bool fits = (may("joint") && robot.jointIndex(e.at) >= 0) || (may("everywhere") && e.at == "*") ||
                    (may("link") && robot.linkIndex(e.at) >= 0) ||
                    (may("foot") && robot.footIndex(e.at) >= 0) || (may("imu") && e.at == "imu") ||
                    (may("ground") && e.at == "ground");
  if (!fits) throw std::runtime_error(e.effect + ": " + robot.name + " has no place \"" + e.at + "\" for it");
  if (kind->hasAxis != !e.axis.empty() || (kind->hasAxis && e.axis != "x" && e.axis != "y" && e.axis != "z"))
    throw std::runtime_error(e.effect + ": axis \"" + e.axis + "\" does not fit");
}

std::vector<int> jointsOf(const RealityEffect& effect, const Mechanism& robot) {
  std::vector<int> joints;
  const int at = robot.jointIndex(effect.at);
  for (int j = 0; j < robot.numJoints(); ++j) {
    const int driver = robot.joints[static_cast<std::size_t>(j)].driver;
    const int motor = driver >= 0 ? driver : j;
    const int wanted = at >= 0 && robot.joints[static_cast<std::size_t>(at)].driver >= 0
                           ? robot.joints[static_cast<std::size_t>(at)].driver
                           : at;
    if (effect.at == "*" || (at >= 0 && motor == wanted)) joints.push_back(j);
  }
  return joints;
}

Mechanism changedBody(Mechanism robot, const std::vector<RealityEffect>& effects) {
  for (const RealityEffect& e : effects) {
    const int index = robot.linkIndex(e.at);
    if (index < 0) continue;
    Mechanism::Link& link = robot.links[static_cast<std::size_t>(index)];
    if (e.effect == "link_mass") {
      if (e.choice("load", "point") == "spread") link.inertia *= (link.mass + e.value) / link.mass;
      link.mass += e.value;
      if (!(link.mass > 0)) throw std::runtime_error("link_mass: " + e.at + " would weigh nothing");
    }
    if (e.effect == "payload") attach(link, e.value, endOf(robot, index));
    if (e.effect == "com_offset") link.com += e.value * axisVector(e.axis);
    if (e.effect == "link_length") {
      for (Mechanism::Joint& joint : robot.joints)
        if (joint.parent == index) joint.origin *= e.value;
      for (Mechanism::Foot& foot : robot.feet)
        if (foot.link == index) foot.soleCentre.z() *= e.value;
      if (e.choice("com", "along") == "along") link.com *= e.value;
    }
  }
  return robot;
}

Vec3 axisVector(const std::string& axis) {
  return axis == "x" ? Vec3::UnitX() : axis == "y" ? Vec3::UnitY() : Vec3::UnitZ();
}

}  // namespace plumbline::reality
