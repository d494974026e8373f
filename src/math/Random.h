#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace plumbline {

/// SplitMix64 (Steele, Lea and Flood 2014): each bit of the input changes about half of the output's.
constexpr std::uint64_t splitMix64(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

/// Random numbers that are the same for the same seed on every machine: xoshiro256++ (Blackman and Vigna,
/// "Scrambled Linear Pseudorandom Number Generators", 2021), its state filled by splitmix64.
class Random {
public:
  explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      word = splitMix64(seed);
      seed += 0x9e3779b97f4a7c15ULL;
    }
  }

  std::uint64_t next() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  /// In [lower, upper).
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
  /// Mean 0, deviation 1 (Marsaglia's polar method).
  double gaussian() {
    for (;;) {
      const double u = uniform(-1, 1), v = uniform(-1, 1), s = u * u + v * v;
      if (s > 0 && s < 1) return u * std::sqrt(-2 * std::log(s) / s);
    }
  }

private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace plumbline
