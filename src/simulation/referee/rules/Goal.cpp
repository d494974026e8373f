#include "simulation/referee/rules/Goal.h"

#include "simulation/referee/Award.h"
#include "simulation/referee/StartKickOff.h"
#include "simulation/referee/TakenKicks.h"
#include "simulation/referee/rules/PassMode.h"

namespace plumbline::simulation {

using simspark::opponent;

MAKE_RULE(Goal, "goals", 50)

namespace {

/// A restart went straight into the goal of a side.
void punishDirectGoal(Match& match, TeamSide kicker, TeamSide goalOf) {
  match.memory.kick.indirect = false;
  if (kicker == goalOf)
    awardCornerKick(match, opponent(kicker));
  else
    awardGoalKick(match, goalOf);
}

bool straightFromKick(Match& match, TeamSide goalOf) {
  return match.rules.restarts.noIndirectGoal && match.memory.agents > 2 && stillFromKick(match) &&
         (match.memory.kick.indirect || match.ball().lastTouch().side == goalOf);
}

bool goal(Match& match) {
  const TeamSide goalOf = match.ball().inGoalOf();
  if (!match.rules.of<Goal>().on || goalOf == TeamSide::none) return false;
  const TeamSide scorer = opponent(goalOf);
  const TakenKickOff& kickOff = match.memory.kickOff;
  if (!kickOff.mayScore && kickOff.taker.side == scorer) {
    punishDirectGoal(match, kickOff.taker.side, goalOf);
  } else if (straightFromKick(match, goalOf)) {
    punishDirectGoal(match, match.ball().lastTouch().side, goalOf);
  } else if (passScoreWait(match, scorer) > 0) {
    awardGoalKick(match, goalOf);
  } else {
    ++match.game.score[Game::index(scorer)];
    match.game.setMode(modeOf(PlayMode::goalLeft, scorer));
  }
  return true;
}

void afterGoal(Match& match, TeamSide scorer) {
  clearForKickOff(match, opponent(scorer));
  if (match.game.modeTime() < match.rules.time.goalPause) return;
  match.placeBall(Vec3(0, 0, match.field.ballRadius));
  startKickOff(match, opponent(scorer));
}

}  // namespace

void Goal::play(Match& match) {
  if (match.ballInPlay() && !match.settled) match.settled = goal(match);
  if (const TeamSide scorer = sideOf(match.mode, PlayMode::goalLeft); scorer != TeamSide::none) {
    match.suspended = true;
    afterGoal(match, scorer);
  }
}

}  // namespace plumbline::simulation
