#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plumbline {

/// The payload of one message of SimSpark's say effector: 20 characters of 64 letters, which no parser takes
/// for anything else (A-Z a-z 0-9 + -), are 120 bits. Written and read from the first bit on.
class SayBits {
public:
  static constexpr int numBits = 120;
  static constexpr std::size_t textLength = 20;

  /// Appends the lower `count` (at most 32) bits of a value. Throws std::length_error beyond 120 bits.
  void write(std::uint32_t value, int count);
  /// The next bits; zeros beyond the end.
  std::uint32_t read(int count);
  /// To read or write from this bit on.
  void seek(int bit) { next_ = bit; }

  std::string text() const;
  /// Nothing if it is not 20 letters of the alphabet.
  static std::optional<SayBits> fromText(std::string_view text);

private:
  std::array<std::uint8_t, numBits> bits_{};  ///< one each: short, and no arithmetic across bytes
  int next_ = 0;
};

/// A number of `bits` bits for a value between two limits, and back to the middle of its step; beyond the
/// limits the nearest one. Error at most half a step, (upper - lower) / 2^bits / 2.
std::uint32_t quantise(double value, double lower, double upper, int bits);
double unquantise(std::uint32_t code, double lower, double upper, int bits);

}  // namespace plumbline
