#include "simulation/referee/rules/LostMessages.h"

#include "math/Random.h"
#include "simulation/referee/Rules.h"

namespace plumbline::simulation {

MAKE_RULE(LostMessages, "lostMessages", 170)

namespace {

std::uint64_t idOf(int player) { return static_cast<std::uint64_t>(player); }

}  // namespace

bool LostMessages::loses(const Rules& rules, const Words& words) const {
  const double share = rules.of<LostMessages>().share;
  if (share <= 0) return false;
  const std::uint64_t lot =
      splitMix64(splitMix64(splitMix64(splitMix64(words.seed) ^ words.cycle) ^ idOf(words.speaker)) ^
                 idOf(words.listener));
  return static_cast<double>(lot >> 11) * 0x1p-53 < share;
}

}  // namespace plumbline::simulation
