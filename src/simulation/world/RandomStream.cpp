#include "simulation/world/RandomStream.h"

#include <cmath>

namespace plumbline::simulation {

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                         static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)};
  engine_.seed(sequence);
}

double RandomStream::uniform(double low, double high) {
  const double unit = static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  return low + (high - low) * unit;
}

double RandomStream::normal() {
  if (haveSpare_) {
    haveSpare_ = false;
    return spare_;
  }
  double x = 0, y = 0, square = 0;
  do {
    x = uniform(-1, 1);
    y = uniform(-1, 1);
    square = x * x + y * y;
  } while (square >= 1 || square == 0);
  const double factor = std::sqrt(-2 * std::log(square) / square);
  spare_ = y * factor;
  haveSpare_ = true;
  return x * factor;
}

}  // namespace plumbline::simulation
