#include "simspark/NumberFormat.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace plumbline::simspark {

void appendFixed(std::string& out, double value, int decimals) {
  static constexpr std::array<double, 10> powers = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
  const double power = powers[static_cast<std::size_t>(decimals)];
  const double scaled = std::fabs(value) * power;
  if (!(scaled < 9e15)) {  // beyond exact integers, or not a number: rare enough for printf
    std::array<char, 512> buffer;
    const int n = std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
    out.append(buffer.data(), static_cast<std::size_t>(n));
    return;
  }
  auto digits = static_cast<std::uint64_t>(std::llrint(scaled));
  std::array<char, 24> buffer;
  char* const end = buffer.data() + buffer.size();
  char* p = end;
  for (int i = 0; i < decimals; ++i) {
    *--p = static_cast<char>('0' + digits % 10);
    digits /= 10;
  }
  if (decimals > 0) *--p = '.';
  do {
    *--p = static_cast<char>('0' + digits % 10);
    digits /= 10;
  } while (digits != 0);
  if (std::signbit(value)) *--p = '-';
  out.append(p, static_cast<std::size_t>(end - p));
}

void appendGeneral(std::string& out, float value) {
  if (value == 0 || value == 1) {  // most entries of a scene
    out += value == 1 ? "1" : std::signbit(value) ? "-0" : "0";
    return;
  }
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), static_cast<double>(value),
                                    std::chars_format::general, 6);
  out.append(buffer.data(), result.ptr);
}

void appendInteger(std::string& out, int value) {
  std::array<char, 16> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), result.ptr);
}

namespace {
template <typename Number>
std::optional<Number> parse(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}
}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  const auto value = parse<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parseInteger(std::string_view text) { return parse<int>(text); }

}  // namespace plumbline::simspark
