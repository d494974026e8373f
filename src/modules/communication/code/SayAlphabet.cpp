#include "modules/communication/code/SayAlphabet.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline {
namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-";
constexpr int bitsOfLetter = 6;

}  // namespace

void SayBits::write(std::uint32_t value, int count) {
  if (count < 0 || count > 32 || next_ + count > numBits)
    throw std::length_error("a message has 120 bits; " + std::to_string(next_) + " are used, " +
                            std::to_string(count) + " more were to be written");
  for (int bit = count - 1; bit >= 0; --bit) bits_[static_cast<std::size_t>(next_++)] = (value >> bit) & 1u;
}

std::uint32_t SayBits::read(int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i, ++next_)
    value = value << 1 | (next_ < numBits ? bits_[static_cast<std::size_t>(next_)] : 0u);
  return value;
}

std::string SayBits::text() const {
  std::string text;
  for (std::size_t i = 0; i < bits_.size(); i += bitsOfLetter) {
    std::size_t letter = 0;
    for (std::size_t bit = 0; bit < bitsOfLetter; ++bit) letter = letter << 1 | bits_[i + bit];
    text += letters[letter];
  }
  return text;
}

std::optional<SayBits> SayBits::fromText(std::string_view text) {
  if (text.size() != textLength) return std::nullopt;
  SayBits bits;
  for (const char c : text) {
    const std::size_t letter = letters.find(c);
    if (letter == std::string_view::npos) return std::nullopt;
    bits.write(static_cast<std::uint32_t>(letter), bitsOfLetter);
  }
  bits.seek(0);
  return bits;
}

std::uint32_t quantise(double value, double lower, double upper, int bits) {
  const double steps = std::ldexp(1.0, bits);
  const double share = std::isfinite(value) ? (value - lower) / (upper - lower) : 0;
  return static_cast<std::uint32_t>(std::clamp(std::floor(share * steps), 0.0, steps - 1));
}

double unquantise(std::uint32_t code, double lower, double upper, int bits) {
  return lower + (upper - lower) * (code + 0.5) / std::ldexp(1.0, bits);
}

}  // namespace plumbline
