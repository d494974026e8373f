#pragma once
#include <string>
#include <vector>

#include "gap/effects/Effects.h"

namespace plumbline::gap {

/// An effect at a place with a value: one cause of a gap.
struct Cause {
  const Effect* effect = nullptr;
  Place place;
  double value = 0;
  int variant = 0;

  bool operator==(const Cause&) const = default;
  bool sameKind(const Cause& other) const { return effect == other.effect && place == other.place; }
};

/// For people: "backlash at LKneePitch = 0.031 rad".
std::string describe(const Cause& cause);

/// A set of causes that together are to explain the data.
using Explanation = std::vector<Cause>;

/// The nominal plant with the causes put in, in order.
Plant plantOf(const Mechanism& mechanism, const Explanation& causes);

}  // namespace plumbline::gap
