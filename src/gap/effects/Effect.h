#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/effects/DrawRange.h"
#include "gap/effects/TakeOut.h"
#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// Where an effect can be.
enum class Site { joint, everywhere, link, imu, foot, ground };

/// One place of one effect on one robot.
struct Place {
  Site site = Site::joint;
  /// Joint, link or foot of the mechanism; for Site::everywhere a group of joints, or -1 for all.
  int index = -1;
  std::string at;    ///< the contract's name: a joint, a link, a foot, a group, "*", "imu", "ground"
  char axis = '\0';  ///< 'x', 'y', 'z', or 0 where the effect has no axis

  bool operator==(const Place&) const = default;
};

/// Least and largest value.
struct Bounds {
  double lower, upper;
};

/// What the screening of a diagnosis must know about an effect before it tries it.
struct Screening {
  bool inNeighbours = false;  ///< can show elsewhere in the chain more than at the joint itself
  /// Lets a link swing behind its gear: the encoder at the motor shows less of that than the joints that
  /// carry it.
  bool behindGear = false;
  /// Whether it shows only on the feet: no; as a weak motor in the leg joint with the largest gap; in any leg
  /// joint.
  enum class UnderLoad { no, weakMotor, anyLeg };
  UnderLoad underLoad = UnderLoad::no;
};

/// The effect with which it is easily confused. Hard cases of blind benchmarks are drawn from effects that
/// have one.
struct LookAlike {
  std::string_view id = {};
  int turn = 1000;  ///< its place among the hard cases; those of the same turn are sorted by order
};

/// Its part in the fit of all joints at once (gap/inference/PerJointFit.h), in which every joint has a value
/// of it.
struct PerJointPart {
  int rank = 0;     ///< from 1, in which it is fitted; those of the same rank by order; 0: it has no part
  int variant = 0;  ///< which of its forms all joints have
};

/// What a simulator may lack: one physical cause with one parameter. Each is in a file of its own and
/// registered by MAKE_EFFECT.
struct Effect {
  std::string_view id;  ///< as in answers and files of effects
  int order = 1000;     ///< its place in lists; those of the same order are sorted by id
  std::string_view unit;
  std::vector<Site> sites;
  bool hasAxis = false;
  double nominal = 0;
  double lower = 0, upper = 0;  ///< of the value, in the unit; scaled per place by scale()
  /// Values that a search starts from, within the bounds; the effect is visible at these.
  std::vector<double> starts;
  /// Whether twice the value is about twice the change: then one starting value is enough.
  bool linear = false;
  /// Acts from a moment on, which is earlier for a larger value; so that moment shows the value.
  bool setsIn = false;
  /// Holds a joint until the load is large enough; in another engine the joint moves a moment earlier or
  /// later.
  bool sticks = false;
  /// A limit or a share of one: acts by its reciprocal, so half the value is twice the effect.
  bool reciprocal = false;
  /// An effect of the servo and its gear: a robot whose servos are all of one type may have it equally in
  /// all.
  bool ofServo = false;
  /// Its times matter and are decoded from a recording; the value is then counted, not fitted.
  bool decoded = false;
  /// Commands come into force later: what lost commands do on average.
  bool delaysCommands = false;
  /// Can be set in a servo: recordings of one robot may have been made with and without it.
  bool setting = false;
  /// The difference between engines with the same value looks like a value that is off by up to this share of
  /// nominal.
  double engineShare = 0;
  /// Prior probability of a value below nominal, if there can be one.
  double belowShare = 0.5;
  /// Forms of the same cause between which the data decides (such as the encoder's side); empty: one.
  std::vector<std::string_view> variants = {};
  std::string_view sentence;   ///< for people; {at} is the place
  std::string_view exposedBy;  ///< motions that show it
  /// Factor on lower, upper and starts at a place: a joint's torque limit, say. Null: 1.
  std::function<double(const Mechanism&, const Place&)> scale = {};
  /// Adds the effect to a plant that may already have others.
  std::function<void(Plant&, const Place&, double value, int variant)> apply = {};
  /// Whether the project's own walk in Bullet can be recorded with it.
  bool inWalk = false;
  /// Its rank, from 1, among the possible reasons for an unexplained gap at a joint; 0: it is not one.
  int suspect = 0;
  /// The nominal value means that the effect is absent: values are not measured from it, and scales do not
  /// show it.
  bool nominalIsNone = false;
  LookAlike alike = {};
  /// Whether a robot can have it at one of its places. Null: yes.
  std::function<bool(const Mechanism&, const Place&)> canBeAt = {};
  Screening screening = {};
  DrawRange drawing = {};
  PerJointPart perJointFit = {};  ///< only for effects of joints
  TakeOut planting = {};

  /// A small change of the value can be another event: derivatives do not show where the density rises.
  bool isRough() const { return sticks || setsIn; }
  int numVariants() const { return variants.empty() ? 1 : static_cast<int>(variants.size()); }
  double scaleAt(const Mechanism& mechanism, const Place& place) const {
    if (!scale) return 1;
    // At Site::everywhere a servo's effect has the size for the first joint.
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
  /// Strength of a value: 0 for nominal, twice the strength for about twice the effect; and the value of a
  /// strength.
  double strengthOf(double value) const { return reciprocal ? 1 / value - 1 / nominal : value - nominal; }
  double valueAt(double strength) const {
    return reciprocal ? 1 / (strength + 1 / nominal) : strength + nominal;
  }
};

/// Calls change(drive) for the joint of a place, for all of a group, or for all joints where the place is
/// "*". An effect at one of two joints that share a motor is at both.
void atJoints(Plant& plant, const Place& place, const std::function<void(JointPlant&)>& change);

/// Adds an effect to effects() before main. An incomplete effect, or a second one with the same id, ends the
/// program at its start: that is a mistake in the build.
class EffectLoader {
public:
  explicit EffectLoader(const Effect& effect);
};

/// In the effect's .cpp: registers it for recording, diagnosis, report and benchmarks.
#define MAKE_EFFECT(name) static const ::plumbline::gap::EffectLoader name##Loader(name)

/// Unit vector of an axis letter.
Vec3 unitVector(char axis);

}  // namespace plumbline::gap
