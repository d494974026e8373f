#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"
#include "math/Random.h"

namespace plumbline::gap {

enum class Battery { hang, all };

struct DrawOptions {
  std::size_t cases = 27;
  std::uint64_t seed = 1;
  Battery battery = Battery::hang;
  bool outside = true;  ///< whether the engine has effects that the library lacks
};

/// The kinds of so many cases: a fifth none, a seventh each of mixtures, of effects outside the library and
/// of hard ones, the rest singles. In an order that the seed draws.
std::vector<BlindKind> drawKinds(const DrawOptions& options);

/// Effects for one case, sizes within the range of each effect (doc/reference/gap-blind.md). `turn` walks
/// through the effects, so that a set has all of them before any comes again.
std::vector<BlindEffect> drawEffects(const Mechanism& robot, BlindKind kind, std::size_t turn,
                                     const DrawOptions& options, Random& random);

/// The effect with its distance from nominal so many times as large (where the value is a limit or a factor
/// below 1: as much stronger). Stays within the library's bounds.
BlindEffect strengthened(const Mechanism& robot, BlindEffect effect, double factor);

/// Programs of a battery, in order; the last one repeats one before it.
std::vector<std::string> programsOf(Battery battery);

}  // namespace plumbline::gap
