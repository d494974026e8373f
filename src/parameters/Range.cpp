#include "parameters/Range.h"

#include <array>
#include <charconv>
#include <cmath>

namespace plumbline {
namespace {

template <typename Number>
std::string shortest(Number value) {
  std::array<char, 40> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

}  // namespace

std::string shortestText(double value) { return shortest(value); }
std::string shortestText(float value) { return shortest(value); }

std::string boundsText(const Range& range) {
  if (std::isinf(range.max)) return "at least " + shortestText(range.min);
  if (std::isinf(range.min)) return "at most " + shortestText(range.max);
  return "within [" + shortestText(range.min) + ", " + shortestText(range.max) + "]";
}

}  // namespace plumbline
