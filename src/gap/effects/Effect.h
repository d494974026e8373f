#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/effects/DrawRange.h"
#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// Where an effect can sit.
enum class Site { joint, everywhere, link, imu, foot, ground };

/// One place of one effect on one robot.
struct Place {
  Site site = Site::joint;
  /// Joint, link or foot of the mechanism; of Site::everywhere a group of joints, or -1 for all of them.
  int index = -1;
  std::string at;    ///< the contract's name: a joint, a link, a foot, a group, "*", "imu", "ground"
  char axis = '\0';  ///< 'x', 'y', 'z', or 0 where the effect has no axis

  bool operator==(const Place&) const = default;
};

/// Least and largest value.
struct Bounds {
  double lower, upper;
};

/// What the screening of a diagnosis has to know of an effect before it tries it.
struct Screening {
  bool inNeighbours = false;  ///< can show elsewhere in the chain more than at the joint itself
  /// Lets a link swing behind its gear: the encoder at the motor sees less of that than the joints that carry
  /// it.
  bool behindGear = false;
  /// What of it shows only on the feet: nothing; a weak motor, in the leg joint that is off most; in any leg
  /// joint.
  enum class UnderLoad { no, weakMotor, anyLeg };
  UnderLoad underLoad = UnderLoad::no;
};

/// The effect that it has been taken for. Hard cases of blind benchmarks are drawn from those that have one.
struct LookAlike {
  std::string_view id = {};
  int turn = 1000;  ///< where it stands among the hard cases; those of the same turn by their order
};

/// What a simulator may lack: one physical cause with one parameter. Each stands in a file of its own, which
/// MAKE_EFFECT makes known.
struct Effect {
  std::string_view id;  ///< as in the contract
  int order = 1000;     ///< where it stands in lists; those of the same order by their ids
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
  /// Whether the project's own walk in Bullet can be recorded with it.
  bool inWalk = false;
  /// Where it stands among what a gap at a joint that nothing explains is suspected to be, from 1; 0: not
  /// one.
  int suspect = 0;
  /// The nominal value stands for none: nothing is measured from it, no scale shows it.
  bool nominalIsNone = false;
  LookAlike alike = {};
  /// Whether a robot can have it at one of its places. Null: yes.
  std::function<bool(const Mechanism&, const Place&)> canBeAt = {};
  Screening screening = {};
  DrawRange drawing = {};

  int numVariants() const { return variants.empty() ? 1 : static_cast<int>(variants.size()); }
  double scaleAt(const Mechanism& mechanism, const Place& place) const {
    if (!scale) return 1;
    // Everywhere a servo's effect has the size that it has at the first joint.
    if (ofServo && place.site == Site::everywhere) {
      const int first =
          place.index < 0 ? 0 : mechanism.groups[static_cast<std::size_t>(place.index)].joints[0];
      return scale(mechanism, {Site::joint, first, mechanism.joints[static_cast<std::size_t>(first)].name});
    }
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

/// Calls change(drive) for the joint of a place, for all of a group, or for all joints where the place is
/// "*". An effect at one of two joints that share a motor is at both.
void atJoints(Plant& plant, const Place& place, const std::function<void(JointPlant&)>& change);

/// Takes an effect into effects() before main. An effect that is not whole, or a second one of the same id,
/// ends the program start: that is a mistake of the build.
class EffectLoader {
public:
  explicit EffectLoader(const Effect& effect);
};

/// In the effect's .cpp: makes it known to recording, diagnosis, report and benchmarks.
#define MAKE_EFFECT(name) static const ::plumbline::gap::EffectLoader name##Loader(name)

/// Unit vector of an axis letter.
Vec3 unitVector(char axis);

}  // namespace plumbline::gap
