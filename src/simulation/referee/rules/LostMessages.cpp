#include "simulation/referee/rules/LostMessages.h"

namespace plumbline::simulation {

MAKE_RULE(LostMessages, "lostMessages", 170)

namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): each bit of the input changes about half of the output's.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15;
  value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9;
  value = (value ^ value >> 27) * 0x94d049bb133111eb;
  return value ^ value >> 31;
}

std::uint64_t idOf(int player) { return static_cast<std::uint64_t>(player); }

}  // namespace

bool LostMessages::isLost(const Parameters& rules, std::uint64_t seed, std::uint64_t cycle, int speaker,
                          int listener) {
  if (rules.share <= 0) return false;
  const std::uint64_t lot = mixed(mixed(mixed(mixed(seed) ^ cycle) ^ idOf(speaker)) ^ idOf(listener));
  return static_cast<double>(lot >> 11) * 0x1p-53 < rules.share;
}

}  // namespace plumbline::simulation
