#include "robot/MechanismCheck.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <numbers>
#include <set>

#include "robot/MechanismParts.h"

namespace plumbline {
namespace {

/// The allowed range of a number, and its usual range on robots from a finger to a crane.
struct Bounds {
  const char* what;
  const char* unit;
  double possibleMin, possibleMax;
  double plausibleMin, plausibleMax;
};

constexpr double maxLength = 1e3;  // [m]
// The minimum of masses and inertias is MuJoCo's mjMINVAL.
constexpr Bounds linkMass{"mass", "kg", 1e-15, 1e6, 1e-5, 1e3};
constexpr Bounds robotMass{"the mass of all links", "kg", 1e-15, 1e7, 1e-4, 2e3};
constexpr Bounds momentOfInertia{"the largest moment of inertia", "kg m^2", 1e-15, 1e8, 0, 1e8};
constexpr Bounds jointOrigin{"the distance of its origin from the parent's", "m", 0, maxLength, 0, 5};
constexpr Bounds slideLimit{"the limit farthest from 0", "m", 0, maxLength, 0, 10};
constexpr Bounds torque{"max_torque", "N m", 1e-9, 1e9, 1e-4, 1e4};
constexpr Bounds force{"max_torque", "N", 1e-9, 1e9, 1e-3, 1e5};
constexpr Bounds speed{"max_speed", "rad/s", 1e-6, 1e6, 1e-2, 100};
constexpr Bounds slideSpeed{"max_speed", "m/s", 1e-9, 1e4, 1e-4, 20};
constexpr Bounds gain{"servo: kp", "N m/rad", 1e-9, 1e9, 1e-4, 1e5};
constexpr Bounds slideGain{"servo: kp", "N/m", 1e-9, 1e12, 1e-3, 1e7};
constexpr Bounds damping{"servo: kd", "N m s/rad", 0, 1e9, 0, 1e4};
constexpr Bounds dryFriction{"friction", "N m", 0, 1e9, 0, 1e3};
constexpr Bounds slideFriction{"friction", "N", 0, 1e9, 0, 1e4};
constexpr Bounds passiveDamping{"damping", "N m s/rad", 0, 1e9, 0, 1e4};
constexpr Bounds armature{"servo: armature", "kg m^2", 0, 1e6, 0, 10};
constexpr Bounds slideArmature{"servo: armature", "kg", 0, 1e6, 0, 1e4};
constexpr Bounds supply{"servo: dc_motor: vin", "V", 1e-6, 1e6, 1, 1e3};
constexpr Bounds resistance{"servo: dc_motor: R", "Ohm", 1e-9, 1e9, 1e-3, 1e4};
constexpr Bounds motorConstant{"servo: dc_motor: kt", "N m/A", 1e-9, 1e6, 1e-4, 1e3};
constexpr Bounds dutyLimit{"servo: dc_motor: max_pwm", "as a share of the supply", 0, 1, 0, 1};
constexpr Bounds gravityBounds{"gravity", "m/s^2", 0, 1e5, 0, 30};
constexpr Bounds rate{"rates: control_hz", "Hz", 1e-3, 1e6, 1, 2e4};

class Checker {
public:
  Checker(const Mechanism& m, const std::string& file, const MechanismWarnings& warn)
      : m_(m), file_(file), warn_(warn), reach_(std::max(1.0, 2 * size())) {}

  void run() const {
    check("", gravityBounds, m_.gravity.norm());
    check("", rate, m_.controlHz);
    for (std::size_t i = 0; i < m_.links.size(); ++i)
      if (i > 0 || m_.links[i].mass > 0) checkLink(m_.links[i]);
    if (m_.totalMass() > 0) check("", robotMass, m_.totalMass());
    for (const Mechanism::Joint& joint : m_.joints) checkJoint(joint);
  }

private:
  /// From the base to the farthest joint, all links stretched out [m].
  double size() const {
    std::vector<double> length(m_.links.size(), 0);
    for (const Mechanism::Joint& joint : m_.joints)
      length[static_cast<std::size_t>(joint.child)] =
          length[static_cast<std::size_t>(joint.parent)] + joint.origin.norm();
    return *std::max_element(length.begin(), length.end());
  }

  static std::string prefix(const std::string& place) { return place.empty() ? "" : place + ": "; }
  [[noreturn]] void fail(const std::string& place, const std::string& what) const {
    failMechanism(file_, prefix(place) + what);
  }
  void doubt(const std::string& place, const std::string& what) const {
    if (warn_) warn_(file_ + ": " + prefix(place) + what);
  }

  void check(const std::string& place, const Bounds& b, double value) const {
    const std::string text = std::string(b.what) + " is " + numberText(value);
    if (!(value >= b.possibleMin && value <= b.possibleMax))
      fail(place, text + ", which is impossible; give it " + b.unit + ", " + numberText(b.possibleMin) +
                      " to " + numberText(b.possibleMax));
    if (value < b.plausibleMin || value > b.plausibleMax)
      doubt(place, text + ", far from " + (value < b.plausibleMin ? "the smallest" : "the largest") +
                       " known of robots; is it in " + b.unit + "?");
  }

  void checkLink(const Mechanism::Link& link) const {
    const std::string place = "link " + link.name;
    check(place, linkMass, link.mass);
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(link.inertia, Eigen::EigenvaluesOnly);
    const Vec3 moments = solver.eigenvalues();  // ascending
    // A singular matrix can come out as slightly positive.
    if (!(moments[0] > 1e-9 * moments[2]))
      fail(place, "the inertia is not positive definite; check order and signs");
    check(place, momentOfInertia, moments[2]);
    // A flat plate reaches the limit, and files round their figures.
    constexpr double rounding = 1e-3;
    if (moments[0] + moments[1] < (1 - rounding) * moments[2])
      fail(place, "moments of inertia about the principal axes are " + numberText(moments[0]) + ", " +
                      numberText(moments[1]) + " and " + numberText(moments[2]) +
                      ", which no body has: the smaller two must add up to the largest; check the order "
                      "[ixx, iyy, izz, ixy, ixz, iyz] and that they are about the centre of mass");
    checkExtent(link, moments[2]);
  }

  void checkExtent(const Mechanism::Link& link, double largestMoment) const {
    const std::string place = "link " + link.name;
    const double com = link.com.norm();
    if (com > maxLength)
      fail(place, "com is " + numberText(com) + " m away, which is impossible; give it in m");
    if (com > reach_)
      doubt(place, "com is " + numberText(com) + " m away, farther than the robot is long; is it in m?");
    const double radius = std::sqrt(largestMoment / link.mass);
    if (radius > maxLength)
      fail(place, "mass and inertia are those of a body of radius " + numberText(radius) +
                      " m, which is impossible; give them in kg and kg m^2");
    constexpr double smallest = 1e-4;
    if (radius > reach_ || radius < smallest)
      doubt(place, "mass and inertia are those of a body of radius " + numberText(radius) +
                       " m; are they in kg and kg m^2?");
  }

  void checkJoint(const Mechanism::Joint& joint) const {
    const std::string place = "joint " + joint.name;
    const bool slides = joint.type == Mechanism::Joint::Type::prismatic;
    check(place, jointOrigin, joint.origin.norm());
    if (slides)
      check(place, slideLimit, std::max(std::abs(joint.lower), std::abs(joint.upper)));
    else
      for (const auto& [name, limit] : {std::pair{"lower", joint.lower}, std::pair{"upper", joint.upper}})
        checkTurn(place, name, limit);
    check(place, slides ? force : torque, joint.maxTorque);
    check(place, slides ? slideSpeed : speed, joint.maxSpeed);
    const Servo& servo = joint.servo;
    check(place, slides ? slideFriction : dryFriction, joint.friction);
    check(place, passiveDamping, joint.damping);
    if (servo.kp != 0) check(place, slides ? slideGain : gain, servo.kp);
    check(place, damping, servo.kd);
    check(place, slides ? slideArmature : armature, servo.armature);
    if (servo.model != Servo::Model::dcMotor) return;
    check(place, supply, servo.vin);
    check(place, resistance, servo.R);
    check(place, motorConstant, servo.kt);
    check(place, dutyLimit, servo.maxPwm);
  }

  /// A joint without stops has limits of maxTurns; others stop within two turns.
  void checkTurn(const std::string& place, const std::string& name, double limit) const {
    constexpr double turn = 2 * std::numbers::pi;
    const double size = std::abs(limit);
    if (size > Mechanism::maxTurns)
      fail(place, name + " is " + numberText(limit) +
                      ", which is impossible; give it in rad, -1000 to 1000 for a joint without stops");
    if (size > 2 * turn && size < Mechanism::maxTurns)
      doubt(place, name + " is " + numberText(limit) + ", " + numberText(std::round(10 * size / turn) / 10) +
                       " turns; is it in rad? A joint without stops has 1000");
  }

  const Mechanism& m_;
  const std::string& file_;
  const MechanismWarnings& warn_;
  const double reach_;
};

}  // namespace

void warnOnStandardError(const std::string& line) {
  static std::mutex mutex;
  static std::set<std::string> known;
  const std::lock_guard lock(mutex);
  constexpr std::size_t enough = 1000;  // of lines that a process remembers and prints
  if (known.size() < enough && known.insert(line).second) std::fprintf(stderr, "warning: %s\n", line.c_str());
}

void requirePositionServos(const Mechanism& mechanism) {
  for (const Mechanism::Joint& joint : mechanism.joints)
    if (!(joint.servo.kp > 0))
      failMechanism(mechanism.name, "joint " + joint.name +
                                        " takes torques alone, but positions are to be commanded; give it a "
                                        "position servo with kp and kd in the robot's file");
}

void checkMechanism(const Mechanism& mechanism, const std::string& file, const MechanismWarnings& warn) {
  Checker(mechanism, file, warn).run();
}

}  // namespace plumbline
