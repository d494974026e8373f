#include "simulation/referee/rules/PassMode.h"

#include <algorithm>

#include "simulation/referee/Reposition.h"

namespace plumbline::simulation {

using simspark::opponent;

namespace {

void passModeBefore(Match& match, TeamSide side) {
  PassRecord& pass = match.pass(side);
  pass = {.last = match.game.time, .ball = pass.ball};
  match.pass(opponent(side)).last = Participant::never;
  const bool touched = match.ball().lastTouch().side != TeamSide::none &&
                       match.ball().lastTouch().time >= match.game.lastModeChange;
  if (match.game.modeTime() >= match.rules.pass.duration || touched) match.game.setMode(PlayMode::playOn);
}

void watchPass(Match& match) {
  const TeamSide side = passScoreWait(match, TeamSide::left) > 0    ? TeamSide::left
                        : passScoreWait(match, TeamSide::right) > 0 ? TeamSide::right
                                                                    : TeamSide::none;
  if (side == TeamSide::none) return;
  PassRecord& pass = match.pass(side);
  const Vec2 way = match.ball().position().head<2>() - pass.ball;
  pass.leftCircle = pass.leftCircle || way.norm() >= match.rules.pass.minOpponentDistance;
  for (const BallTouch& touch : match.ball().touching()) {
    if (touch.side != side) continue;
    if (pass.firstToucher == 0) pass.firstToucher = touch.unum;
    pass.moreTouched = pass.moreTouched || touch.unum != pass.firstToucher;
    pass.clearedToScore = pass.clearedToScore || (pass.moreTouched && pass.leftCircle);
  }
}

}  // namespace

MAKE_RULE(PassMode, "passMode", 30)

void PassMode::passAsked(Match& match, const Participant& player) {
  const Rules::Pass& rules = match.rules.pass;
  if (!rules.on || match.game.mode != PlayMode::playOn) return;
  if (match.game.time - match.pass(player.side).last < rules.retryWait) return;
  if (match.ball().touchedBy(player.side) || match.ball().speed() > rules.maxBallSpeed) return;
  const Vec2 ball = match.ball().position().head<2>();
  if ((player.place() - ball).norm() > rules.maxBallDistance) return;
  const bool opponentNear =
      std::any_of(match.participants().begin(), match.participants().end(), [&](const Participant& other) {
        return other.side == opponent(player.side) &&
               (other.place() - ball).norm() < rules.minOpponentDistance;
      });
  if (opponentNear) return;
  match.pass(player.side).ball = ball;
  match.game.setMode(modeOf(PlayMode::passLeft, player.side));
}

void PassMode::play(Match& match) {
  if (const TeamSide side = sideOf(match.mode, PlayMode::passLeft); side != TeamSide::none)
    passModeBefore(match, side);
  if (match.ballInPlay()) watchPass(match);
}

void PassMode::afterPlay(Match& match) {
  const TeamSide side = sideOf(match.mode, PlayMode::passLeft);
  if (side == TeamSide::none || match.game.mode != match.mode) return;
  match.pass(side).ball = match.ball().position().head<2>();
  repel(match, match.ball().position(), match.rules.pass.minOpponentDistance, opponent(side), 0.1);
}

void PassMode::end(Match& match) {
  for (const TeamSide side : {TeamSide::left, TeamSide::right})
    match.game.passScoreWait[Game::index(side)] =
        match.game.mode == PlayMode::playOn ? passScoreWait(match, side) : 0;
}

double passScoreWait(Match& match, TeamSide side) {
  const PassRecord& pass = match.pass(side);
  if (!match.rules.pass.on || pass.clearedToScore) return 0;
  return std::max(0.0, match.rules.pass.scoreWait - (match.game.time - pass.last));
}

}  // namespace plumbline::simulation
