#include "framework/Stopwatch.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

double Stopwatch::mean() const {
  const std::uint64_t n = count();
  return n == 0 ? 0 : total() / static_cast<double>(n);
}

double Stopwatch::upperEnd(std::size_t bin) {
  constexpr std::size_t perOctave = 1u << fractionBits;
  if (bin < perOctave) return static_cast<double>(bin);
  const auto shift = static_cast<int>(bin / perOctave) - 1;
  return std::ldexp(static_cast<double>(perOctave + bin % perOctave + 1), shift) - 1;
}

double Stopwatch::percentile(double part) const {
  const std::uint64_t n = count();
  if (n == 0) return 0;
  const auto wanted = std::clamp<double>(std::ceil(part * static_cast<double>(n)), 1, static_cast<double>(n));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < binCount; ++i) {
    seen += bins_[i].load(std::memory_order_relaxed);
    if (static_cast<double>(seen) >= wanted) return std::min(1e-9 * upperEnd(i), max());
  }
  return max();
}

}  // namespace plumbline
