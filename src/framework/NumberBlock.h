#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace plumbline {

/// What one number of a block is; `bytes` is 1, 2, 4 or 8.
struct NumberType {
  enum class Kind : std::uint8_t { signedInteger, unsignedInteger, floatingPoint, character };
  Kind kind;
  unsigned bytes;
};

/// Numbers that may follow each other in a block of memory: any bytes are a valid value, which
/// is not so for bool and enums.
template <typename T>
concept BlockNumber =
    (std::integral<T> && !std::same_as<T, bool>) || std::same_as<T, float> || std::same_as<T, double>;

template <BlockNumber T>
constexpr NumberType numberType() {
  using Kind = NumberType::Kind;
  if (std::same_as<T, char>) return {Kind::character, 1};
  if (std::is_floating_point_v<T>) return {Kind::floatingPoint, sizeof(T)};
  return {std::is_signed_v<T> ? Kind::signedInteger : Kind::unsignedInteger, sizeof(T)};
}

}  // namespace plumbline
