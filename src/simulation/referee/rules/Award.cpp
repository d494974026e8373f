#include "simulation/referee/rules/Award.h"

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
      Vec3(sign(side) * (fieldLength / 2 - match.rules.restarts.goalKick), 0, ballRadius);
  award(match, PlayMode::goalKickLeft, side);
}

void awardCornerKick(Match& match, TeamSide side) {
  const double y = (fieldWidth + goalWidth) / 4 - ballRadius;
  match.memory.kickPosition = Vec3(-sign(side) * (fieldLength / 2 - ballRadius),
                                   match.ball().position().y() > 0 ? y : -y, ballRadius);
  award(match, PlayMode::cornerKickLeft, side);
}

void awardKickIn(Match& match, TeamSide side) {
  const Vec3& last = match.ball().lastOnField();
  const double y = fieldWidth / 2 - ballRadius;
  match.memory.kickPosition = Vec3(last.x(), last.y() > 0 ? y : -y, ballRadius);
  award(match, PlayMode::kickInLeft, side);
}

void awardFreeKick(Match& match, TeamSide side, bool indirect) {
  award(match, indirect ? PlayMode::freeKickLeft : PlayMode::directFreeKickLeft, side);
}

}  // namespace plumbline::simulation
