#pragma once
#include <cstdint>
#include <string>

namespace plumbline::bench {

/// Log odds from which on a pair is decided: 20 to 1.
inline constexpr double decided = 3;

/// Two explanations that one recording leaves open, and what further motions made of them. Log odds are those
/// of what is in the robot against its rival, both fitted to all recordings that there are.
struct Pair {
  std::string robot, truth, rival, first, proposed, random;
  double before = 0, withProposed = 0, withRandom = 0;
  std::size_t draws = 0;
  std::size_t inseparable =
      0;  ///< pairs drawn before of which bin/gap next says that no motion tells them apart
};

/// The pair of a turn: drawn and played, or as it was kept.
Pair pairOf(const std::string& folder, std::size_t turn, std::uint64_t seed, int jobs);

}  // namespace plumbline::bench
