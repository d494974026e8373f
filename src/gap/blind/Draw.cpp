#include "gap/blind/Draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "gap/effects/Effects.h"

namespace plumbline::gap {

namespace {

/// In what a range is given: as it is, in the joint's largest torque, in its kd.
enum class Unit { plain, torque, damping };
enum class Where { joint, jointOrAll, all, link, imu, foot, ground };
enum class Growth {
  distance,  ///< from nothing: twice as strong is twice the value
  factor,    ///< from 1: twice as strong is its square
  limit      ///< from infinity: twice as strong is half
};

struct Range {
  std::string_view id;
  Where where;
  double low, high;
  Unit unit = Unit::plain;
  bool bothSigns = false;
  double low2 = 0, high2 = 0;  ///< another range, as likely
  Growth growth = Growth::distance;
  std::string_view axes = {};
  bool standing = false;  ///< only seen on the feet
};

constexpr std::array ranges = {
    Range{"command_delay", Where::jointOrAll, .003, .02},
    Range{"command_dropout", Where::all, .03, .15},
    Range{"servo_gain", Where::joint, .6, .85, Unit::plain, false, 1.2, 1.5, Growth::factor},
    Range{"servo_damping", Where::joint, .3, .7, Unit::plain, false, 1.4, 2.5, Growth::factor},
    Range{"torque_limit", Where::joint, .1, .3, Unit::plain, false, 0, 0, Growth::factor},
    Range{"speed_limit", Where::joint, .1, .35, Unit::plain, false, 0, 0, Growth::factor},
    Range{"coulomb_friction", Where::joint, .03, .12, Unit::torque},
    Range{"viscous_friction", Where::joint, .3, 1, Unit::damping},
    Range{"stribeck_friction", Where::joint, .05, .15, Unit::torque},
    Range{"load_friction", Where::joint, .15, .4},
    Range{"backlash", Where::joint, .02, .08},
    Range{"joint_compliance", Where::joint, .02, .08},
    Range{"acceleration_limit", Where::joint, 10, 40, Unit::plain, false, 0, 0, Growth::limit},
    Range{"dead_band", Where::joint, .005, .02},
    Range{"supply_voltage", Where::all, .12, .3, Unit::plain, false, 0, 0, Growth::factor},
    Range{"bias_force", Where::joint, .04, .12, Unit::torque, true},
    Range{"thermal_derating", Where::joint, .005, .02},
    Range{"rotor_inertia", Where::joint, .006, .03},
    Range{"joint_offset", Where::joint, .04, .15, Unit::plain, true},
    Range{"encoder_nonlinearity", Where::joint, .02, .06, Unit::plain, true},
    Range{"link_mass", Where::link, .08, .3},
    Range{"com_offset", Where::link, .015, .04, Unit::plain, true, 0, 0, Growth::distance, "xyz"},
    Range{"link_length", Where::link, .8, .92, Unit::plain, false, 1.08, 1.2, Growth::factor},
    Range{"imu_misalignment", Where::imu, .03, .1, Unit::plain, true, 0, 0, Growth::distance, "xy"},
    Range{"gyro_bias", Where::imu, .02, .1, Unit::plain, true, 0, 0, Growth::distance, "xyz"},
    Range{"imu_delay", Where::imu, .01, .04, Unit::plain, false, 0, 0, Growth::distance, "", true},
    Range{"fsr_gain", Where::foot, .7, .9, Unit::plain, false, 1.1, 1.3, Growth::factor, "", true},
    Range{"ground_friction", Where::ground, .1, .3, Unit::plain, false, 0, 0, Growth::factor, "", true},
    Range{"ground_slope", Where::ground, .02, .08, Unit::plain, true, 0, 0, Growth::distance, "xy", true},
    Range{"ground_compliance", Where::ground, 3e-5, 3e-4, Unit::plain, false, 0, 0, Growth::distance, "",
          true},
    Range{"external_force", Where::link, 1.5, 6, Unit::plain, true, 0, 0, Growth::distance, "xyz", true},
};

constexpr std::array outsideRanges = {
    Range{"gear_ripple", Where::joint, .08, .2, Unit::torque},
    Range{"joint_spring", Where::joint, .1, .4, Unit::torque},
    Range{"cable_spring", Where::joint, .15, .5, Unit::torque},
    Range{"asymmetric_damping", Where::joint, .5, 1.5, Unit::damping},
    Range{"gain_drift", Where::joint, .3, .6},
    Range{"servo_integral", Where::joint, 1, 4},
    Range{"command_lag", Where::joint, .02, .06},
    Range{"crosstalk", Where::joint, .05, .2},
    Range{"bristle_friction", Where::joint, .05, .15, Unit::torque},
    Range{"acc_bias", Where::imu, .4, 1.2, Unit::plain, true, 0, 0, Growth::distance, "xyz"},
};

// Pairs of neighbours: each has been taken for the other.
constexpr std::array<std::string_view, 16> alike = {
    "coulomb_friction", "stribeck_friction", "servo_gain",    "joint_compliance",
    "viscous_friction", "servo_damping",     "backlash",      "dead_band",
    "torque_limit",     "thermal_derating",  "link_mass",     "com_offset",
    "joint_offset",     "bias_force",        "load_friction", "rotor_inertia"};

template <class List>
auto pick(const List& list, Random& random) {
  return list[std::min(list.size() - 1,
                       static_cast<std::size_t>(random.uniform() * static_cast<double>(list.size())))];
}

const Range* find(std::string_view id) {
  for (const Range& r : ranges)
    if (r.id == id) return &r;
  for (const Range& r : outsideRanges)
    if (r.id == id) return &r;
  return nullptr;
}

std::vector<std::string> placesFor(const Mechanism& robot, Where where) {
  std::vector<std::string> places;
  if (where == Where::joint || where == Where::jointOrAll) {
    for (const Mechanism::Joint& joint : robot.joints)
      if (joint.driver < 0) places.push_back(joint.name);
  } else if (where == Where::link) {
    const double lightest = std::min(0.07, robot.totalMass() / 60);  // [kg]; below that a link is a bracket
    for (std::size_t l = 1; l < robot.links.size(); ++l)
      if (robot.links[l].mass > lightest) places.push_back(robot.links[l].name);
  } else if (where == Where::foot) {
    for (const Mechanism::Foot& foot : robot.feet) places.push_back(foot.name);
  } else {
    places.emplace_back(where == Where::imu ? "imu" : where == Where::ground ? "ground" : "*");
  }
  if (places.empty())
    throw std::invalid_argument(robot.name + " has no place for some effects of a blind set");
  return places;
}

BlindEffect drawOne(const Mechanism& robot, const Range& range, Random& random) {
  BlindEffect e;
  e.effect = range.id;
  const std::vector<std::string> places = placesFor(robot, range.where);
  e.at = range.where == Where::jointOrAll && random.uniform() < 0.5 ? "*" : pick(places, random);
  if (!range.axes.empty()) e.axis = std::string(1, pick(range.axes, random));
  const bool second = range.high2 > 0 && random.uniform() < 0.5;
  e.value = second ? random.uniform(range.low2, range.high2) : random.uniform(range.low, range.high);
  if (const int joint = robot.jointIndex(e.at); joint >= 0) {
    const Mechanism::Joint& j = robot.joints[static_cast<std::size_t>(joint)];
    if (range.unit == Unit::torque) e.value *= j.maxTorque;
    if (range.unit == Unit::damping) e.value *= j.servo.kd;
  }
  if (range.bothSigns && random.uniform() < 0.5) e.value = -e.value;
  if (range.id == "backlash") e.how["side"] = random.uniform() < 0.5 ? "motor" : "link";
  return e;
}

void shuffle(auto& list, Random& random) {
  for (std::size_t i = list.size(); i > 1; --i)
    std::swap(list[i - 1], list[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
}

}  // namespace

std::vector<BlindKind> drawKinds(const DrawOptions& options) {
  const std::size_t n = options.cases;
  std::vector<BlindKind> kinds;
  kinds.insert(kinds.end(), (n + 2) / 5, BlindKind::none);
  kinds.insert(kinds.end(), (n + 3) / 7, BlindKind::mixture);
  if (options.outside) kinds.insert(kinds.end(), (n + 3) / 7, BlindKind::outside);
  kinds.insert(kinds.end(), (n + 3) / 7, BlindKind::hard);
  kinds.resize(std::max(n, kinds.size()), BlindKind::single);
  Random random(options.seed ^ 0x6b1d);
  shuffle(kinds, random);
  kinds.resize(n);
  return kinds;
}

std::vector<BlindEffect> drawEffects(const Mechanism& robot, BlindKind kind, std::size_t turn,
                                     const DrawOptions& options, Random& random) {
  std::vector<const Range*> list;
  const auto fits = [&](const Range& r) {
    return (!r.standing || options.battery == Battery::all) && !placesFor(robot, r.where).empty() &&
           (r.where != Where::imu || robot.hasImu);
  };
  if (kind == BlindKind::outside) {
    for (const Range& r : outsideRanges)
      if (fits(r)) list.push_back(&r);
  } else if (kind == BlindKind::hard) {
    for (const std::string_view id : alike) list.push_back(find(id));
  } else {
    for (const Range& r : ranges)
      if (fits(r)) list.push_back(&r);
  }
  // The same order throughout a set, another in another set.
  Random order(options.seed ^ (0x0d3 + static_cast<std::uint64_t>(kind)));
  shuffle(list, order);
  if (kind == BlindKind::none || list.empty()) return {};
  if (kind != BlindKind::mixture) {
    BlindEffect e = drawOne(robot, *list[turn % list.size()], random);
    if (kind == BlindKind::hard) e = strengthened(robot, e, 0.5);
    return {e};
  }
  std::vector<BlindEffect> two = {drawOne(robot, *list[2 * turn % list.size()], random)};
  for (;;) {
    BlindEffect other = drawOne(robot, *pick(list, random), random);
    if (other.effect == two[0].effect || (other.at == two[0].at && other.axis == two[0].axis)) continue;
    two.push_back(std::move(other));
    return two;
  }
}

BlindEffect strengthened(const Mechanism& robot, BlindEffect e, double factor) {
  const Range* range = find(e.effect);
  if (!range) return e;
  if (range->growth == Growth::distance) e.value *= factor;
  if (range->growth == Growth::factor) e.value = std::pow(e.value, factor);
  if (range->growth == Growth::limit) e.value /= factor;
  if (const Effect* known = findEffect(e.effect)) {
    const Place place = findPlace(*known, robot, e.at, e.axis);
    const Bounds bounds = known->boundsAt(robot, place);
    e.value = std::clamp(e.value, bounds.lower, bounds.upper);
  }
  return e;
}

std::vector<std::string> programsOf(Battery battery) {
  std::vector<std::string> programs = {"hang_sweep", "hang_multisine", "hang_small", "hang_fast"};
  if (battery == Battery::all)
    for (const char* p : {"stand_squat", "stand_sway", "stand_lean", "stand_turn180"})
      programs.emplace_back(p);
  programs.push_back(programs[3]);
  return programs;
}

}  // namespace plumbline::gap
