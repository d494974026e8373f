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

/// The kinds of the cases: a fifth none, a seventh each mixtures, effects outside the library and hard ones,
/// the rest singles. The seed draws the order.
std::vector<BlindKind> drawKinds(const DrawOptions& options);

/// Effects for one case, sizes within the range of each effect (doc/reference/gap-blind.md). `turn` selects
/// the effects in turn, so that a set has every effect once before it repeats any.
std::vector<BlindEffect> drawEffects(const Mechanism& robot, BlindKind kind, std::size_t turn,
                                     const DrawOptions& options, Random& random);

/// The effect with its distance from nominal multiplied (for limits and factors below 1: its strength). Stays
/// within the library's bounds.
BlindEffect strengthened(const Mechanism& robot, BlindEffect effect, double factor);

/// Programs of a battery, in order; the last one repeats one before it.
std::vector<std::string> programsOf(Battery battery);

}  // namespace plumbline::gap
