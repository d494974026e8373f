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

namespace {

/// A number of the form -12.34 with few digits, which nearly all of the server's have. Numerator and power of
/// ten are exact, so the one rounding is that of the division, and it is what from_chars says.
std::optional<double> parseShort(std::string_view text) {
  constexpr std::size_t mostDigits = 15;
  static constexpr std::array<double, mostDigits + 1> powers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                                1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() > mostDigits) return std::nullopt;
  std::int64_t digits = 0;
  std::size_t point = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c >= '0' && c <= '9')
      digits = 10 * digits + (c - '0');
    else if (c == '.' && point == text.size() && i > 0 && i + 1 < text.size())
      point = i;
    else
      return std::nullopt;
  }
  const std::size_t decimals = point == text.size() ? 0 : text.size() - point - 1;
  const double value = static_cast<double>(digits) / powers[decimals];
  return negative ? -value : value;
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  if (const auto value = parseShort(text)) return value;
  const auto value = parse<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parseInteger(std::string_view text) { return parse<int>(text); }

}  // namespace plumbline::simspark
