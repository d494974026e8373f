#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// Where an effect can sit.
enum class Site { joint, everywhere, link, imu, foot, ground };

/// One place of one effect on one robot.
struct Place {
  Site site = Site::joint;
  int index = -1;    ///< joint, link or foot of the mechanism
  std::string at;    ///< the contract's name: a joint, a link, a foot, "*", "imu", "ground"
  char axis = '\0';  ///< 'x', 'y', 'z', or 0 where the effect has no axis

  bool operator==(const Place&) const = default;
};

/// Least and largest value.
struct Bounds {
  double lower, upper;
};

/// What a simulator may lack: one physical cause with one parameter. Each stands in a file of its own.
struct Effect {
  std::string_view id;  ///< as in the contract
  std::string_view unit;
  std::vector<Site> sites;
  bool hasAxis = false;
  double nominal = 0;
  double lower = 0, upper = 0;  ///< of the value, in the unit; scaled per place by scale()
  /// Values that a search starts from, within the bounds; the effect is visible at these.
  std::vector<double> starts;
  /// Whether twice the value is about twice the change: one starting value then tells of the others.
  bool linear = false;
  /// Acts from a moment on that comes the sooner the larger the value is; that moment tells the value.
  bool setsIn = false;
  /// Holds a joint until enough presses on it; when it lets go, another engine tells a moment sooner or
  /// later.
  bool sticks = false;
  /// A limit or a share of one: acts by its reciprocal, and half the value is twice the effect.
  bool reciprocal = false;
  /// Of the servo and its gear: a robot whose servos are all of one type may have it in all of them alike.
  bool ofServo = false;
  /// What matters is when it happened, which is decoded from a recording; the value is then counted, not
  /// fitted.
  bool decoded = false;
  /// Can be set in a servo: recordings of one robot may have been made with and without it.
  bool setting = false;
  /// What engines do otherwise with the same value looks like one that is off by up to this share of nominal.
  double engineShare = 0;
  /// How likely a value below nominal is before any data, where there can be one.
  double belowShare = 0.5;
  /// Ways of building the same cause that data decide between (such as the encoder's side); empty: one.
  std::vector<std::string_view> variants = {};
  std::string_view sentence;   ///< for people; {at} is the place
  std::string_view exposedBy;  ///< motions that show it
  /// Factor on lower, upper and starts at a place: a joint's torque limit, say. Null: 1.
  std::function<double(const Mechanism&, const Place&)> scale = {};
  /// Puts the effect into a plant that may hold others already.
  std::function<void(Plant&, const Place&, double value, int variant)> apply = {};

  int numVariants() const { return variants.empty() ? 1 : static_cast<int>(variants.size()); }
  double scaleAt(const Mechanism& mechanism, const Place& place) const {
    if (!scale) return 1;
    // Everywhere a servo's effect has the size that it has at the first joint.
    if (ofServo && place.site == Site::everywhere)
      return scale(mechanism, {Site::joint, 0, mechanism.joints.front().name});
    return scale(mechanism, place);
  }
  Bounds boundsAt(const Mechanism& mechanism, const Place& place) const {
    const double factor = scaleAt(mechanism, place);
    return {lower * factor, upper * factor};
  }
  /// How strong a value is: 0 where it is nominal, twice that for about twice the effect; and the other way
  /// round.
  double strengthOf(double value) const { return reciprocal ? 1 / value - 1 / nominal : value - nominal; }
  double valueAt(double strength) const {
    return reciprocal ? 1 / (strength + 1 / nominal) : strength + nominal;
  }
};

/// Calls change(drive) for the joint of a place, or for all joints where the place is "*". An effect at one
/// of two joints that share a motor is at both.
void atJoints(Plant& plant, const Place& place, const std::function<void(JointPlant&)>& change);

/// Unit vector of an axis letter.
Vec3 unitVector(char axis);

}  // namespace plumbline::gap
