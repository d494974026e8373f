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
  /// Recordings (Trial::recording) without it: a servo may have been set otherwise there.
  std::vector<std::string> inactiveIn = {};

  bool operator==(const Cause&) const = default;
  bool sameKind(const Cause& other) const { return effect == other.effect && place == other.place; }
};

/// For people: "backlash at LKneePitch = 0.031 rad".
std::string describe(const Cause& cause);
/// For people, where a cause was not in force in every recording: "not set in multisine"; else empty.
std::string describeInactiveIn(const Cause& cause);

/// A set of causes that together are to explain the data.
using Explanation = std::vector<Cause>;

/// Whether a value is no farther from the model's than engines are from each other.
bool withinEngines(const Cause& cause);

/// Whether a value is so near the nominal one that it does nothing: what gains all the same gains by the
/// finer steps that are taken where a gear has play or gives way.
bool doesNothing(const Mechanism& mechanism, const Cause& cause);

/// Whether a cause lies in a sensor of the body: inertial, or of force.
bool ofSensor(const Cause& cause);

/// All but the i-th.
Explanation without(Explanation causes, std::size_t i);

/// Whether lost commands are among the causes (Effect::decoded).
bool losesCommands(const Explanation& causes);

/// The largest number of causes at one joint, at least 1: effects that the library lacks can be put together
/// from several of it.
int mostAtOneJoint(const Explanation& causes);

/// The nominal plant with the causes put in, in order.
Plant plantOf(const Mechanism& mechanism, const Explanation& causes);
/// The robot as a trial drove it, with the causes put in that were in force in its recording.
Plant plantOf(const Trial& trial, const Explanation& causes);
bool inForce(const Cause& cause, const Trial& trial);

}  // namespace plumbline::gap
