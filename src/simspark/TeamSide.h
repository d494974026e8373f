#pragma once
#include <string_view>

namespace plumbline::simspark {

/// The half a team defends; the first team that comes is left.
enum class TeamSide { none, left, right };

constexpr TeamSide opponent(TeamSide side) {
  return side == TeamSide::left ? TeamSide::right : side == TeamSide::right ? TeamSide::left : TeamSide::none;
}

/// As the server writes it to agents.
constexpr std::string_view sideName(TeamSide side) {
  return side == TeamSide::left ? "left" : side == TeamSide::right ? "right" : "none";
}

}  // namespace plumbline::simspark
