#pragma once
#include <string>
#include <vector>

#include "gap/effects/Effects.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// An effect at a place with a value: one cause of a gap.
struct Cause {
  const Effect* effect = nullptr;
  Place place;
  double value = 0;
  int variant = 0;
  /// Recordings (Trial::recording) without it: the servo may have had another setting there.
  std::vector<std::string> inactiveIn = {};

  bool operator==(const Cause&) const = default;
  bool sameKind(const Cause& other) const { return effect == other.effect && place == other.place; }
  bool sameForm(const Cause& other) const { return sameKind(other) && variant == other.variant; }
};

/// For people: "backlash at LKneePitch = 0.031 rad".
std::string describe(const Cause& cause);
/// For people, if a cause was not active in every recording: "not set in multisine"; else empty.
std::string describeInactiveIn(const Cause& cause);

/// A set of causes that together are to explain the data.
using Explanation = std::vector<Cause>;

/// Whether a value differs from the model's by no more than engines differ from each other.
bool withinEngines(const Cause& cause);

/// Whether a value is so near the nominal one that it has no effect. If such a cause gains, it gains only by
/// the shorter steps for gears with backlash or compliance.
bool doesNothing(const Mechanism& mechanism, const Cause& cause);

/// Whether a cause is in a sensor of the body (inertial or force).
bool ofSensor(const Cause& cause);

/// All but the i-th.
Explanation without(Explanation causes, std::size_t i);

/// Whether lost commands are among the causes (Effect::decoded).
bool losesCommands(const Explanation& causes);

/// The largest number of causes at one joint, at least 1: several effects of the library together can imitate
/// one that it lacks.
int mostAtOneJoint(const Explanation& causes);

/// The nominal plant with the causes put in, in order.
Plant plantOf(const Mechanism& mechanism, const Explanation& causes);
/// The robot as a trial drove it, with the causes that were active in its recording.
Plant plantOf(const Trial& trial, const Explanation& causes);
bool inForce(const Cause& cause, const Trial& trial);
/// In how many of these recordings a cause was not active.
std::size_t inactiveAmong(const Cause& cause, const std::vector<std::string>& recordings);
/// Whether a cause is expected in a recording that was not seen: at least half of those seen had it.
bool isExpectedElsewhere(const Cause& cause, const std::vector<std::string>& recordings);

}  // namespace plumbline::gap
