#include "simulation/referee/rules/LostMessages.h"

#include "math/Random.h"

namespace plumbline::simulation {

MAKE_RULE(LostMessages, "lostMessages", 170)

namespace {

std::uint64_t idOf(int player) { return static_cast<std::uint64_t>(player); }

}  // namespace

bool LostMessages::isLost(const Parameters& rules, std::uint64_t seed, std::uint64_t cycle, int speaker,
                          int listener) {
  if (rules.share <= 0) return false;
  const std::uint64_t lot =
      splitMix64(splitMix64(splitMix64(splitMix64(seed) ^ cycle) ^ idOf(speaker)) ^ idOf(listener));
  return static_cast<double>(lot >> 11) * 0x1p-53 < rules.share;
}

}  // namespace plumbline::simulation
