#include "simulation/referee/Award.h"

#include "simulation/referee/Areas.h"

namespace plumbline::simulation {

namespace {

void award(Match& match, PlayMode left, TeamSide side) {
  match.memory.repelKickers = true;
  match.game.setMode(modeOf(left, side));
}

}  // namespace

void awardGoalKick(Match& match, TeamSide side) {
  match.memory.kickPosition =
      Vec3(sign(side) * (match.field.length / 2 - match.rules.restarts.goalKick), 0, match.field.ballRadius);
  award(match, PlayMode::goalKickLeft, side);
}

void awardCornerKick(Match& match, TeamSide side) {
  const double y = (match.field.width + match.field.goalWidth) / 4 - match.field.ballRadius;
  match.memory.kickPosition = Vec3(-sign(side) * (match.field.length / 2 - match.field.ballRadius),
                                   match.ball().position().y() > 0 ? y : -y, match.field.ballRadius);
  award(match, PlayMode::cornerKickLeft, side);
}

void awardKickIn(Match& match, TeamSide side) {
  const Vec3& last = match.ball().lastOnField();
  const double y = match.field.width / 2 - match.field.ballRadius;
  match.memory.kickPosition = Vec3(last.x(), last.y() > 0 ? y : -y, match.field.ballRadius);
  award(match, PlayMode::kickInLeft, side);
}

void awardFreeKick(Match& match, TeamSide side, bool indirect) {
  award(match, indirect ? PlayMode::freeKickLeft : PlayMode::directFreeKickLeft, side);
}

}  // namespace plumbline::simulation
