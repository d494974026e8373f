#include "modules/motion/WalkDrawing.h"

#include <array>

namespace plumbline {

using namespace walking;

namespace {

constexpr double halfLength = 0.08, halfWidth = 0.04;  ///< of a sole as drawn [m]

std::array<Vec2, 4> cornersOf(const Pose2& foot) {
  return {foot * Vec2(halfLength, halfWidth), foot * Vec2(-halfLength, halfWidth),
          foot * Vec2(-halfLength, -halfWidth), foot * Vec2(halfLength, -halfWidth)};
}

void outline(Drawing& drawing, const Pose2& foot, const shapes::Colour& colour) {
  const auto corners = cornersOf(foot);
  for (std::size_t i = 0; i < 4; ++i) drawing.line(corners[i], corners[(i + 1) % 4], colour);
  drawing.line(foot.position, Vec2(foot * Vec2(halfLength, 0)), colour, 1);
}

void drawState(Drawing& drawing, const WalkState& state, const shapes::Colour& colour) {
  for (const Side side : {Side::left, Side::right}) {
    const Pose2& foot = state.foot[index(side)];
    outline(drawing, foot, colour);
    if (state.support != supportOf(side) && state.support != Support::both) continue;
    const auto corners = cornersOf(foot);
    drawing.polygon({corners.begin(), corners.end()}, colours::faint(colour, 0.35));
  }
  drawing.point(Vec2(0, 0), colour, 8);
  drawing.arrow(Vec2(0, 0), state.velocity, colour, 1);
}

/// All in the frame of the centre of mass.
void enter(Drawing& drawing, const WalkEngine& engine) {
  drawing.in(DrawingFrame::robot, engine.plan().torso.inverse());
}

}  // namespace

void drawWalk(Drawing& drawing, const WalkEngine& engine) {
  enter(drawing, engine);
  drawState(drawing, engine.observed(), colours::white);
  drawState(drawing, engine.state(), colours::green);
}

void drawPlannedSteps(Drawing& drawing, const WalkEngine& engine, int count) {
  enter(drawing, engine);
  const WalkState& state = engine.state();
  if (state.support == Support::both) return;
  Side carries = state.supportSide();
  Pose2 landing = state.supportFoot() * engine.plan().landing;
  for (int i = 0; i < count; ++i) {
    outline(drawing, landing, i == 0 ? colours::yellow : colours::faint(colours::yellow, 0.6));
    // The foot that landed carries; the other one's place is that of the walk aimed at, a step later.
    carries = other(carries);
    const WalkState& next = engine.reference().begin[index(other(carries))];
    landing = landing * next.foot[index(carries)].inverse() * next.foot[index(other(carries))];
  }
}

}  // namespace plumbline
