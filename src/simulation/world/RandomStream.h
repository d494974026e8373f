#pragma once
#include <cstdint>
#include <random>

namespace plumbline::simulation {

/// Random numbers that are the same on every standard library: only the engine is the standard's, whose bits
/// are specified; the distributions are ours.
class RandomStream {
public:
  /// Streams of one seed are independent of each other: each player has its own, so that a player's noise
  /// does not change when another joins.
  explicit RandomStream(std::uint64_t seed = 1, std::uint64_t stream = 0);

  /// In [low, high).
  double uniform(double low, double high);
  /// Mean 0, standard deviation 1: the polar method (Marsaglia and Bray 1964).
  double normal();

private:
  std::mt19937_64 engine_;
  double spare_ = 0;
  bool haveSpare_ = false;
};

}  // namespace plumbline::simulation
