#pragma once
#include <string>
#include <vector>

#include "framework/Drawing.h"
#include "modules/behavior/formation/TeamPlan.h"

namespace plumbline {

/// "goalie", "striker", "supporter 3" (at the third place of the formation); "no role". See PlayerRole.
std::string roleText(int role);

/// Draws a player's role: its text at the place of the role, and a line from the player to there. The place
/// of a striker is the ball. A goalie has none, and the text is at the player. Team's frame [m]; number:
/// in the text, 0 leaves it out.
void drawRole(Drawing& drawing, const Vec2& player, int number, int role, const Vec2& ball,
              const std::vector<Vec2>& places, const shapes::Colour& colour);

/// The role of each member; the first 11 members.
void drawPlan(Drawing& drawing, const std::vector<TeamMember>& team, const std::vector<int>& roles,
              const Vec2& ball, const std::vector<Vec2>& places);

}  // namespace plumbline
