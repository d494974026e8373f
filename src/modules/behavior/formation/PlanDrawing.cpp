#include "modules/behavior/formation/PlanDrawing.h"

#include <fmt/format.h>

#include "field/TeamSize.h"

namespace plumbline {

std::string roleText(int role) {
  if (role == PlayerRole::goalie) return "goalie";
  if (role == PlayerRole::striker) return "striker";
  if (role >= PlayerRole::supporter) return fmt::format("supporter {}", role - PlayerRole::supporter + 1);
  return "no role";
}

void drawRole(Drawing& drawing, const Vec2& player, int number, int role, const Vec2& ball,
              const std::vector<Vec2>& places, const shapes::Colour& colour) {
  const std::string text = (number > 0 ? std::to_string(number) + " " : "") + roleText(role);
  const auto place = static_cast<std::size_t>(role - PlayerRole::supporter);
  const bool supports = role >= PlayerRole::supporter && place < places.size();
  if (!supports && role != PlayerRole::striker) return drawing.text(player, text, colour);
  const Vec2& to = supports ? places[place] : ball;
  drawing.line(player, to, colour, 2);
  if (supports) drawing.circle(to, 0.15, colour, 2);
  drawing.text(to, text, colour);
}

void drawPlan(Drawing& drawing, const std::vector<TeamMember>& team, const std::vector<int>& roles,
              const Vec2& ball, const std::vector<Vec2>& places) {
  constexpr std::size_t most = teamSize;
  for (std::size_t i = 0; i < team.size() && i < roles.size() && i < most; ++i)
    drawRole(drawing, team[i].pose.position, team[i].number, roles[i], ball, places,
             roles[i] == PlayerRole::striker ? colours::orange : colours::blue);
}

}  // namespace plumbline
