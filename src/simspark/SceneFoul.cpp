#include "simspark/SceneFoul.h"

#include <array>

#include "simspark/NumberFormat.h"

namespace plumbline::simspark {

std::optional<SceneFoul> readFoul(SExpressions::Node list) {
  std::array<int, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const SExpressions::Node word = list.at(i + 1);
    const auto number = word ? parseInteger(word.text()) : std::nullopt;
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  const auto [index, kind, side, unum] = numbers;
  if (index < 1 || kind < 0 || kind >= static_cast<int>(FoulKind::none) || side < 1 || side > 2)
    return std::nullopt;
  return SceneFoul{index, static_cast<FoulKind>(kind), side == 1 ? TeamSide::left : TeamSide::right, unum};
}

}  // namespace plumbline::simspark
