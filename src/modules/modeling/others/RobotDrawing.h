#pragma once
#include <vector>

#include "framework/Drawing.h"
#include "representations/modeling/OtherRobots.h"

namespace plumbline {

/// The colours of beliefs: own sight, messages of mates, both combined.
namespace beliefColours {
inline constexpr shapes::Colour sight = colours::cyan, heard = colours::yellow, combined = colours::white;
}

/// Draws each robot: its position with the ellipse of two standard deviations, its number, and a cross if it
/// lies. Mates are points, opponents red points. The first 22 only: more players are in no game. The robots
/// are in the team's frame, and so must the drawing be.
void drawRobots(Drawing& drawing, const std::vector<OtherRobot>& robots, const shapes::Colour& colour);

}  // namespace plumbline
